namespace Harvester.Geometry.Work;

/// <summary>
/// One step of a work that is spread over the ticks of a game. A work is a sequence of steps, written as an iterator: between two of its
/// steps it stands still. After a step it either may be interrupted, or needs the next tick, or begins another work, whose steps all come
/// before its own next one. <see cref="WorkRun"/> advances works. docs/decisions/0027-stepped-work.md says why.
/// </summary>
public readonly record struct WorkStep
{
    private WorkStep(IEnumerable<WorkStep>? work, bool needsTick, int? phase) => (Work, NeedsTick, Phase) = (work, needsTick, phase);

    /// <summary>The work may be interrupted here, if the time of the tick is over.</summary>
    public static WorkStep Pause => default;

    /// <summary>The work goes on in the next tick, however much time is left.</summary>
    public static WorkStep Tick { get; } = new(null, true, null);

    /// <summary>The work that is done before the next step; null for none.</summary>
    public IEnumerable<WorkStep>? Work { get; }

    /// <summary>Whether the next step belongs to the next tick.</summary>
    public bool NeedsTick { get; }

    /// <summary>Number of the phase that the owner of the run shows; null for the phase of the work that this step is part of.</summary>
    public int? Phase { get; }

    /// <summary>The work goes on in the next tick; meanwhile the run is in a phase.</summary>
    /// <param name="phase">Number of the phase.</param>
    public static WorkStep TickIn(int phase) => new(null, true, phase);

    /// <summary>Another work is done before the next step.</summary>
    /// <param name="work">The steps of that work.</param>
    /// <param name="phase">Number of the phase that the run is in wherever that work stands still; null for the present one.</param>
    public static WorkStep Do(IEnumerable<WorkStep> work, int? phase = null) =>
        new(work ?? throw new ArgumentNullException(nameof(work)), false, phase);
}
