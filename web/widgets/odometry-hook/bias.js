/**
 * The bias that a filter has learned, in the words of the slider: the nominal radius exceeds the true one by this part
 * of the true one. The filter's own state ε is the same difference as a part of the nominal radius.
 */

/** @param {number} epsilon @param {number} sigma one standard deviation of ε */
export const learned = (epsilon, sigma) => ({ bias: epsilon / (1 - epsilon), sigma: sigma / (1 - epsilon) ** 2 })
