using Harvester.Geometry;
using Harvester.Sessions.Events;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;

namespace Harvester.Datasets.Validation;

/// <summary>
/// Finds hard braking in the labels alone, where frames are a window apart, and asks for its event: of a simulated game, in which every
/// frame is also a reading. Labels are looked at in their order.
/// </summary>
internal sealed class EventSpeedCheck
{
    /// <summary>Mean deceleration over the window from which braking is hard, m/s², and the window, seconds: docs/events.md.</summary>
    private const double HardBraking = 0.45 * 9.80665;
    private const double Window = 0.5;

    /// <summary>Frames whose distance in time differs by more from the window say nothing, seconds.</summary>
    private const double TimeTolerance = 2e-6;

    /// <summary>Error of a deceleration from speeds that are rounded to 0.1 mm/s, m/s².</summary>
    private const double Rounding = 0.001;

    /// <summary>Farther from the ego, metres, a vehicle may have been out of the range of 100 m between the frames.</summary>
    private const double SafeRange = 80;

    /// <summary>One that has moved by more beyond its speed was placed elsewhere, metres: docs/events.md.</summary>
    private const double Jump = 1;

    private const int Ego = 0;

    /// <summary>One with more events is not looked at: a text from outside must not take forever.</summary>
    private const int MaxEvents = 10_000;

    private readonly Dictionary<int, DrivingEvent[]> _events;
    private readonly Queue<(double Seconds, Dictionary<int, (Vector3D Position, Vector3D Velocity)> Bodies)> _frames = new();

    public EventSpeedCheck(IEnumerable<DrivingEvent> events) =>
        _events = events
            .Where(each => each.Kind is EventKind.HardBraking or EventKind.Collision)
            .SelectMany(each => each.Participants.Select(participant => (Id: participant.Object ?? Ego, Event: each)))
            .GroupBy(each => each.Id, each => each.Event)
            .ToDictionary(each => each.Key, each => each.ToArray());

    /// <summary>What hard braking the label shows without an event.</summary>
    public IEnumerable<string> Problems(FrameLabel label)
    {
        var now = new Dictionary<int, (Vector3D Position, Vector3D Velocity)> { [Ego] = (label.Ego.Position, label.Ego.Velocity) };
        foreach (ObjectLabel item in label.Objects.Where(item => item.Parent is null && IsDriven(item.Class)))
        {
            if ((item.Box3D.Centre - label.Ego.Position).Length <= SafeRange)
            {
                now[item.Id] = (item.Box3D.Centre, item.Velocity);
            }
        }

        while (_frames.Count > 0 && _frames.Peek().Seconds < label.TimeSeconds - Window - TimeTolerance)
        {
            _frames.Dequeue();
        }

        if (_frames.Count > 0 && Math.Abs(label.TimeSeconds - Window - _frames.Peek().Seconds) <= TimeTolerance)
        {
            foreach ((int id, (Vector3D Position, Vector3D Velocity) body) in now)
            {
                if (
                    _frames.Peek().Bodies.TryGetValue(id, out (Vector3D Position, Vector3D Velocity) before)
                    && (Speed(before.Velocity) - Speed(body.Velocity)) / Window > HardBraking + Rounding
                    && (body.Position - before.Position).Length <= (before.Velocity.Length * Window) + Jump
                    && !IsExplained(id, label.TimeSeconds)
                )
                {
                    yield return $"{(id == Ego ? "the ego" : $"object {id}")} brakes hard, but no event says so.";
                }
            }
        }

        _frames.Enqueue((label.TimeSeconds, now));
    }

    private static bool IsDriven(ObjectClass kind) => VehicleClasses.AreVehicles(kind) && kind != ObjectClass.Trailer;

    private static double Speed(Vector3D velocity) => Math.Sqrt((velocity.X * velocity.X) + (velocity.Y * velocity.Y));

    private bool IsExplained(int id, double seconds) =>
        _events.TryGetValue(id, out DrivingEvent[]? events)
        && (events.Length > MaxEvents || Array.Exists(events, each => Explains(each, seconds)));

    /// <summary>
    /// Whether an event says what the deceleration up to a moment is: hard braking then, or a collision up to a second before.
    /// </summary>
    private static bool Explains(DrivingEvent each, double seconds) =>
        seconds >= each.BeginSeconds - TimeTolerance
        && seconds <= each.EndSeconds + (each.Kind == EventKind.Collision ? 1 + Window : 0) + TimeTolerance;
}
