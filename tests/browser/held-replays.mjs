/**
 * In the page: the worker's answer to a replay waits from now on, so that the bar stays as long as a test needs it.
 * Called again, it lets the next answers through.
 */
export function holdReplays() {
  const { run } = document.querySelector('robot-log').figure
  const { port } = run
  const held = port.onmessage.held
  port.onmessage = held
    ? (message) => run.hear(message)
    : Object.assign((message) => message.kind === 'there' || run.hear(message), { held: true })
}
