using Harvester.Capture.Ports;

namespace Harvester.Capture.Harvesting;

/// <summary>Counts the native calls and rays of each phase of a harvest.</summary>
/// <param name="calls">The game's counter; null if the game counts nothing.</param>
public sealed class PhaseCalls(ICallCounter? calls)
{
    private readonly SortedDictionary<HarvestPhase, (long Natives, long Rays)> _phases = [];
    private long _natives = calls?.Natives ?? 0;
    private long _rays = calls?.Rays ?? 0;

    /// <summary>The phases with calls: natives (including those of rays) and rays.</summary>
    public IReadOnlyDictionary<HarvestPhase, (long Natives, long Rays)> Phases => _phases;

    /// <summary>Ignores the calls since the last charge: they were not the harvest's.</summary>
    internal void Skip()
    {
        _natives = calls?.Natives ?? 0;
        _rays = calls?.Rays ?? 0;
    }

    /// <summary>Charges the calls since the last charge to a phase.</summary>
    internal void Charge(HarvestPhase phase)
    {
        if (calls is null || calls.Natives == _natives)
        {
            return;
        }

        (long natives, long rays) = _phases.TryGetValue(phase, out (long Natives, long Rays) before) ? before : default;
        _phases[phase] = (natives + calls.Natives - _natives, rays + calls.Rays - _rays);
        Skip();
    }

    /// <summary>The counts as text, for the log.</summary>
    public override string ToString() =>
        string.Join(
            ", ",
            _phases.Select(static phase =>
                FormattableString.Invariant($"{phase.Key} {phase.Value.Natives} natives {phase.Value.Rays} rays")
            )
        );
}
