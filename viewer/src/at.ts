// Reading values that came from elsewhere: each is asked for by name and type, and an error says which one is wrong.

import type { Triple } from "./data.js";

/** The data does not keep the contract; the message says where and how. */
export class DataError extends Error {
  override readonly name = "DataError";
}

/** A value and the path to it, for messages. */
export class At {
  private constructor(
    private readonly value: unknown,
    private readonly path: string,
  ) {}

  static root(value: unknown): At {
    return new At(value, "");
  }

  /** A member that must be there. */
  member(key: string): At {
    return new At(this.record()[key], this.path === "" ? key : `${this.path}.${key}`);
  }

  /** A member that may be missing or null. */
  optional(key: string): At | null {
    const member = this.member(key);
    return member.value === undefined || member.value === null ? null : member;
  }

  list<T>(read: (item: At) => T): T[] {
    if (!Array.isArray(this.value)) throw this.expected("a list");
    return this.value.map((item: unknown, i) => read(new At(item, `${this.path}[${i}]`)));
  }

  string(): string {
    if (typeof this.value !== "string") throw this.expected("a string");
    return this.value;
  }

  boolean(): boolean {
    if (typeof this.value !== "boolean") throw this.expected("true or false");
    return this.value;
  }

  number(): number {
    if (typeof this.value !== "number" || !Number.isFinite(this.value)) throw this.expected("a finite number");
    return this.value;
  }

  triple(): Triple {
    const [x, y, z, ...rest] = this.list((item) => item.number());
    if (x === undefined || y === undefined || z === undefined || rest.length > 0) throw this.expected("three numbers");
    return [x, y, z];
  }

  pair(): [number, number] {
    const [x, z, ...rest] = this.list((item) => item.number());
    if (x === undefined || z === undefined || rest.length > 0) throw this.expected("two numbers");
    return [x, z];
  }

  error(message: string): DataError {
    return new DataError(`${this.path === "" ? "the data" : this.path}: ${message}`);
  }

  private record(): Record<string, unknown> {
    if (typeof this.value !== "object" || this.value === null || Array.isArray(this.value)) throw this.expected("an object");
    return this.value as Record<string, unknown>;
  }

  private expected(what: string): DataError {
    const found = this.value === undefined ? "nothing" : this.value === null ? "null" : Array.isArray(this.value) ? `a list of ${this.value.length}` : typeof this.value;
    return this.error(`expected ${what}, found ${found}`);
  }
}
