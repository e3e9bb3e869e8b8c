/** How far the plane reaches. Its axes hold still while the cloud turns, so an error can lie beyond their ends. */

/** From zero to the upper edge, m/s. */
export const REACH = 3.4
/** From zero to the right edge, m, at the least width of the drawing. */
const ACROSS = 4.5

/** Whether an error, and with it the whole rectangle of its product, is in the drawing. @param {number[]} error */
export const isShown = ([position, velocity]) => Math.abs(position) < ACROSS && Math.abs(velocity) < REACH
