namespace Harvester.Benchmarks.Scenarios;

/// <summary>How a driver fared in the runs of a kind.</summary>
internal sealed class ScenarioScore
{
    private int _runs;
    private int _touched;
    private double _completion;

    /// <summary>Adds a run.</summary>
    /// <param name="hasTouched">Whether the ego touched an actor.</param>
    /// <param name="completion">The part of its way that it drove, 0 to 1.</param>
    public void Add(bool hasTouched, double completion)
    {
        _runs++;
        _touched += hasTouched ? 1 : 0;
        _completion += completion;
    }

    /// <summary>Adds the runs of another.</summary>
    public void Add(ScenarioScore other)
    {
        _runs += other._runs;
        _touched += other._touched;
        _completion += other._completion;
    }

    /// <inheritdoc/>
    public override string ToString() =>
        _runs == 0 ? "-" : FormattableString.Invariant($"{_touched} of {_runs}, {100 * _completion / _runs:0} %");
}
