using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Harvesting;

/// <summary>
/// Counts for how many game frames a scene has stood still. Each reading is compared with the first of the run, not with the one
/// before, so that what creeps slowly is not taken for standing.
/// </summary>
internal sealed class StillnessGate(SceneComparison comparison)
{
    private SceneSnapshot? _first;

    /// <summary>The game frames from the first reading of the run to the latest: 0 after a difference.</summary>
    public long StillTicks { get; private set; }

    public void Observe(SceneSnapshot snapshot)
    {
        if (_first is null || comparison.FirstDifference(_first, snapshot) is not null)
        {
            _first = snapshot;
        }

        StillTicks = snapshot.GameFrame - _first.GameFrame;
    }
}
