using Harvester.Capture.Ports;
using Harvester.Geometry;

namespace Harvester.Driving.Scenarios;

/// <summary>An actor of a scenario that is in the world.</summary>
internal sealed class StagedActor
{
    private double _at;

    /// <param name="bound">The actor at its place.</param>
    /// <param name="handle">Its handle in the game.</param>
    public StagedActor(BoundActor bound, int handle)
    {
        (Bound, Handle, Track, State) = (bound, handle, bound.Track, null);
    }

    /// <summary>The actor at its place.</summary>
    public BoundActor Bound { get; }

    /// <summary>Its handle in the game.</summary>
    public int Handle { get; }

    /// <summary>The line along which it drives now.</summary>
    public LaneTrack Track { get; private set; }

    /// <summary>Its state in this tick; null once it is gone.</summary>
    public StageState? State { get; private set; }

    /// <summary>Metres per second.</summary>
    public double Speed => State is { } state ? new Vector3D(state.Velocity.X, state.Velocity.Y, 0).Length : 0;

    /// <summary>Where it is along its track, metres.</summary>
    public double At => _at;

    /// <summary>Where it is beside its track, metres to the right.</summary>
    public double Right { get; private set; }

    /// <summary>Takes the state of this tick.</summary>
    public void Observe(StageState? state)
    {
        State = state;
        Locate();
    }

    /// <summary>Drives along another line from now on.</summary>
    public void TakeTrack(LaneTrack track)
    {
        Track = track;
        _at = track.Locate(State?.Pose.Position ?? Bound.Ground).At;
        Locate();
    }

    private void Locate()
    {
        if (State is { } state)
        {
            (_at, Right) = Track.Locate(state.Pose.Position, _at);
        }
    }
}
