namespace Harvester.Mod.Tests.Soak;

/// <summary>How often each kind of fault has happened: a soak without faults proves nothing.</summary>
internal sealed class FaultTally
{
    private const int MinOfEach = 50;
    private readonly SortedDictionary<string, long> _counts = new(StringComparer.Ordinal);

    public void Add(string kind) => _counts[kind] = _counts.GetValueOrDefault(kind) + 1;

    /// <summary>Fails where a kind of fault, or a feature, hardly came.</summary>
    public void AssertAllHappened()
    {
        string[] kinds =
        [
            "native threw",
            "native lied",
            "aborted between ticks",
            "aborted within a tick",
            "list threw",
            "list was empty",
            "list lied",
            "pool was full",
            "picture was refused",
            "world was swept",
            "car was left",
            "client drove",
            "radar and HUD were off",
            "entity was hidden",
            "frame was harvested",
            "model was put up",
            "ball was drawn",
            "game stood still",
            "thread of another was refused",
        ];
        Assert.Empty(
            kinds.Where(kind => _counts.GetValueOrDefault(kind) < MinOfEach).Select(kind => $"{kind}: {_counts.GetValueOrDefault(kind)}")
        );
    }

    public override string ToString() => string.Join(", ", _counts.Select(count => $"{count.Key} {count.Value} times"));
}
