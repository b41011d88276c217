/** A planar mechanism that moves, of the declaration that stands in the element or in the file that `src` names. */
export class PlmMechanism extends HTMLElement {
  /** The declaration in the element. A text that is set is shown in the place of what was. */
  declaration: string;
  /** The time of the run, s. */
  readonly time: number;
  readonly isPlaying: boolean;
  play(): void;
  pause(): void;
  /** Begins again with the parameters as they are. */
  restart(): void;
  /** Sets a parameter or an input, in its declared unit; a `RangeError` where there is none of this name. */
  set(name: string, value: number): void;
  /**
   * A parameter or an input in its declared unit, or what is recorded, in the unit of its curve: outputs, and `crank.angle` of a
   * body; a `RangeError` where there is none of this name.
   */
  value(name: string): number;
}

/** A mechanism moves, or stands at its start. */
export type PlmReadyEvent = CustomEvent<{ name: string }>;
/** The text is no mechanism; the message has its diagnostics. */
export type PlmErrorEvent = CustomEvent<{ message: string }>;

declare global {
  interface HTMLElementTagNameMap {
    "plm-mechanism": PlmMechanism;
  }
  interface HTMLElementEventMap {
    "plm-ready": PlmReadyEvent;
    "plm-error": PlmErrorEvent;
  }
}
