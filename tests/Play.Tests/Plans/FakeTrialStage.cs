using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Play.Features;

namespace Harvester.Play.Tests.Plans;

/// <summary>A stage whose actors appear after some ticks and then stand where they were put.</summary>
/// <param name="driveEgo">Sends the player's vehicle on its way, or stops it.</param>
internal sealed class FakeTrialStage(Action<bool> driveEgo) : ITrialStage
{
    private const int EntityOfFirst = 500;
    private readonly SortedDictionary<int, StageActor> _actors = [];
    private int _last;

    /// <summary>Questions after which the actors are there.</summary>
    public int AppearsAfter { get; set; } = 3;

    /// <summary>The actor that the game does not make, by its model.</summary>
    public string? Refused { get; set; }

    /// <summary>What was ordered, in order.</summary>
    public List<string> Done { get; } = [];

    /// <summary>The actors that are or will be there.</summary>
    public IReadOnlyCollection<StageActor> Actors => _actors.Values;

    public bool AreAllThere => AppearsAfter-- <= 0;

    public int EntityOf(int handle) => EntityOfFirst + handle;

    public StageSpawn Spawn(StageActor actor)
    {
        Done.Add($"spawn {actor.Model} {actor.Speed}");
        _actors.Add(++_last, actor);
        return StageSpawn.Of(_last);
    }

    public void Follow(int handle, StageOrder order) => Done.Add($"follow {handle} {order.Speed}");

    public void SetSpeed(int handle, double speed, double acceleration) => Done.Add($"speed {handle} {speed}");

    public void SetDoor(int handle, int side, bool isOpen) => Done.Add($"door {handle}");

    public void SetIndicators(int handle, StageIndicators indicators) => Done.Add($"indicators {handle}");

    public void Remove(int handle) => _actors.Remove(handle);

    public StageState? StateOf(int handle) =>
        _actors.TryGetValue(handle, out StageActor? actor) && actor.Model != Refused
            ? new StageState(
                new Pose(actor.Ground, Axes.FromHeading(actor.HeadingDegrees)),
                Vector3D.Zero,
                IsAtEnd: false,
                HalfLength: 2,
                HalfWidth: 1
            )
            : null;

    public void DriveEgo(StageOrder order)
    {
        Done.Add($"ego {order.Speed}");
        driveEgo(true);
    }

    public void Launch(int handle, double speed) => Done.Add($"launch {handle} {speed}");

    public void Clear()
    {
        Done.Add("clear");
        _actors.Clear();
        driveEgo(false);
    }
}
