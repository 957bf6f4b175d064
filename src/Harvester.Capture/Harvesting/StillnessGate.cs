using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Harvesting;

/// <summary>
/// Counts the game frames for which a scene has stood still. Each reading is compared with the first of the run, not with the previous one,
/// so that slow movement is not mistaken for standing still.
/// </summary>
internal sealed class StillnessGate(SceneComparison comparison)
{
    private SceneSnapshot? _first;
    private long? _start;

    /// <summary>Number of game frames from the very first reading to the first of the run.</summary>
    public long MovingTicks { get; private set; }

    /// <summary>Number of game frames from the first reading of the run to the latest; 0 after a difference.</summary>
    public long StillTicks { get; private set; }

    public void Observe(SceneSnapshot snapshot)
    {
        if (_first is null || comparison.FirstDifference(_first, snapshot) is not null)
        {
            _first = snapshot;
            _start ??= snapshot.GameFrame;
            MovingTicks = snapshot.GameFrame - _start.Value;
        }

        StillTicks = snapshot.GameFrame - _first.GameFrame;
    }
}
