package cga.grading.sandbox

import cga.framework.InputError

/** Runs commands that nobody trusts. Safe to use from several threads. */
public fun interface Sandbox {
    /**
     * Runs [job] to its end, kills what is left of it, and returns.
     *
     * Throws [InputError] when the job could not be started at all; whatever it does once started is an [Outcome].
     */
    public fun run(job: Job): Outcome

    /** Whether a job is kept from all that is none of its business. */
    public val isConfined: Boolean get() = true

    /** The ways to get one. */
    public companion object {
        /** Why [confined] would refuse, with the cure; null where it works. Tried once. */
        public val unavailable: String? by lazy { Confinement.find().exceptionOrNull()?.message }

        /** A sandbox that holds. Throws [InputError] where there is none. */
        public fun confined(): Sandbox = ConfinedRun(Confinement.find().getOrThrow())

        /** The same limits and the same watch, but no walls: for machines that are thrown away afterwards. */
        public fun unconfined(): Sandbox = UnconfinedRun()
    }
}
