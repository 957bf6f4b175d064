using Harvester.Sessions.Events;

namespace Harvester.Capture.Events;

/// <summary>Finds hard braking, of the ego and of other vehicles that drive themselves: the mean deceleration over a window.</summary>
internal sealed class HardBrakingWatch : IEventWatch
{
    /// <inheritdoc/>
    public void Observe(SceneReading reading, EventBook book)
    {
        foreach (RoadUser user in reading.Driven)
        {
            double now = user.Now.Speed;
            if (
                user.SpeedAt(reading.Seconds - EventRules.BrakingWindowSeconds) is not { } before
                || (before - now) / EventRules.BrakingWindowSeconds is var deceleration && deceleration < EventRules.HardBraking
                || book.IsIn(EventKind.Collision, user)
            )
            {
                continue;
            }

            OpenEvent open = book.FindOrBegin(EventKind.HardBraking, reading.Seconds, user);
            if (open.Hold(reading.Seconds, -deceleration))
            {
                open.Measures =
                [
                    new(EventMeasures.Deceleration, deceleration),
                    new(EventMeasures.SpeedBefore, before),
                    new(EventMeasures.SpeedAfter, now),
                ];
            }
        }
    }
}
