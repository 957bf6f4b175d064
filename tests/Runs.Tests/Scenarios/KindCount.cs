namespace Harvester.Runs.Tests.Scenarios;

/// <summary>How often a kind of scenario was staged, happened as described and touched the ego, and how often no place was found.</summary>
internal sealed record KindCount(string Kind, int Staged, int Happened, int Touched, int Skipped)
{
    public static KindCount operator +(KindCount a, KindCount b) =>
        new(a.Kind, a.Staged + b.Staged, a.Happened + b.Happened, a.Touched + b.Touched, a.Skipped + b.Skipped);

    /// <summary>A row of the table in docs/scenarios.md.</summary>
    public override string ToString() => FormattableString.Invariant($"| `{Kind}` | {Happened} of {Staged} | {Skipped} | {Touched} |");
}
