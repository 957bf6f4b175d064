using Harvester.Geometry;
using Harvester.Sessions.Events;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Events;

/// <summary>
/// Finds collisions: footprints that touch and did not at the reading before. The ego with everything, vehicles with vehicles and people.
/// </summary>
internal sealed class CollisionWatch : IEventWatch
{
    /// <inheritdoc/>
    public void Observe(SceneReading reading, EventBook book)
    {
        foreach (OpenEvent open in book.Open.Where(static each => each.Mark.Kind == EventKind.Collision).ToList())
        {
            if (IsContact(open.Users[0].Now.Box, open.Users[1].Now.Box))
            {
                open.Hold(reading.Seconds, 0);
            }

            if (reading.Seconds - open.Begin <= EventRules.CrashPulseSeconds + 1e-6)
            {
                open.Contact = WithSpeedChanges(open.Contact!, open.Users[0], open.Users[1], open.Begin);
            }

            // From this reading on it no longer hides hard braking and near misses.
            if (open.IsOverAt(reading.Seconds))
            {
                book.Close(open, EventEnd.Over, reading.Seconds);
            }
        }

        foreach ((RoadUser first, RoadUser second) in Candidates(reading))
        {
            if (IsBegun(first, second) && book.Find(EventKind.Collision, first, second) is null)
            {
                OpenEvent begun = book.FindOrBegin(EventKind.Collision, reading.Seconds, first, second);
                begun.Hold(reading.Seconds, 0);
                begun.Contact = WithSpeedChanges(ContactOf(first, second), first, second, begun.Begin);
            }
        }
    }

    private static bool IsContact(BodyBox a, BodyBox b) => a.IsLevelWith(b) && a.Gap(b) <= EventRules.ContactMetres;

    private static bool IsBegun(RoadUser first, RoadUser second) =>
        first.Before is { } firstBefore
        && second.Before is { } secondBefore
        && IsContact(first.Now.Box, second.Now.Box)
        && !IsContact(firstBefore.Box, secondBefore.Box);

    /// <summary>The pairs whose footprints may touch, found by sorting their extents from west to east.</summary>
    private static IEnumerable<(RoadUser First, RoadUser Second)> Candidates(SceneReading reading)
    {
        List<RoadUser> users =
        [
            .. new[] { reading.Ego }
                .Concat(reading.Others)
                .Where(static user => !user.IsNew)
                .OrderBy(static user => user.Now.Box.Centre.X - user.Now.Box.Radius),
        ];
        var near = new List<RoadUser>();
        foreach (RoadUser user in users)
        {
            double west = user.Now.Box.Centre.X - user.Now.Box.Radius - EventRules.ContactMetres;
            near.RemoveAll(other => other.Now.Box.Centre.X + other.Now.Box.Radius < west);
            foreach (RoadUser other in near.Where(other => CanCollide(user, other)))
            {
                yield return IsFirst(user, other) ? (user, other) : (other, user);
            }

            near.Add(user);
        }
    }

    private static bool CanCollide(RoadUser a, RoadUser b) =>
        a.IsEgo || b.IsEgo || (a.IsVehicle && (b.IsVehicle || b.IsPerson)) || (b.IsVehicle && a.IsPerson);

    private static bool IsFirst(RoadUser a, RoadUser b) => a.IsEgo || (!b.IsEgo && a.Entity.Handle < b.Entity.Handle);

    private static EventContact ContactOf(RoadUser first, RoadUser second)
    {
        (BodyBox a, BodyBox b) = (first.Now.Box, second.Now.Box);
        Vector2D place = a.Common(b);
        double height = (Math.Max(a.Bottom, b.Bottom) + Math.Min(a.Top, b.Top)) / 2;
        return new EventContact(
            new Vector3D(place.X, place.Y, height),
            a.ToLocal(place),
            b.ToLocal(place),
            (first.Before!.Ground - second.Before!.Ground).Length,
            0,
            0,
            0,
            0,
            0
        );
    }

    private static EventContact WithSpeedChanges(EventContact contact, RoadUser first, RoadUser second, double begin)
    {
        double ofFirst = Math.Max(contact.FirstSpeedChange, SpeedChange(first, begin));
        double ofSecond = Math.Max(contact.SecondSpeedChange, SpeedChange(second, begin));
        ImpulseEstimate impulse = ImpulseEstimate.Of(ClassOf(first), ofFirst, ClassOf(second), ofSecond);
        return contact with
        {
            FirstSpeedChange = ofFirst,
            SecondSpeedChange = ofSecond,
            Impulse = impulse.Usual,
            ImpulseMin = impulse.Min,
            ImpulseMax = impulse.Max,
        };
    }

    private static ObjectClass ClassOf(RoadUser user) => user.Entity.Class;

    /// <summary>Change of the horizontal velocity since the last reading before the contact, m/s.</summary>
    private static double SpeedChange(RoadUser user, double begin) =>
        user.Readings.LastOrDefault(reading => reading.Seconds < begin - 1e-6) is { } before ? (user.Now.Ground - before.Ground).Length : 0;
}
