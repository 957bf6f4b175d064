using Harvester.Sessions.Events;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Events;

/// <summary>Follows the road users from reading to reading and finds the events between them. Definitions: docs/events.md.</summary>
/// <param name="idOf">The id of an object in labels.</param>
/// <param name="firstId">Number of the first event.</param>
internal sealed class EventDetector(Func<EntityState, int> idOf, int firstId)
{
    /// <summary>Collisions come first: they end near misses and hide hard braking.</summary>
    private readonly IEventWatch[] _watches =
    [
        new CollisionWatch(),
        new NearMissWatch(),
        new HardBrakingWatch(),
        new CutInWatch(),
        new StopLineWatch(),
        new OffRoadWatch(),
        new WrongWayWatch(),
    ];

    private Dictionary<int, RoadUser> _others = [];
    private RoadUser? _ego;

    /// <summary>The events.</summary>
    public EventBook Book { get; } = new(firstId);

    /// <summary>Takes a reading, later than the one before.</summary>
    /// <param name="seconds">The game's time, seconds.</param>
    /// <param name="ego">The ego.</param>
    /// <param name="entities">The other entities.</param>
    /// <param name="roads">The roads around them; null if they are not known.</param>
    public void Observe(double seconds, EgoState ego, IEnumerable<EntityState> entities, RoadScene? roads = null)
    {
        RoadUser present = Followed(_ego, RoadUser.Ego(ego), seconds, ego.Pose, ego.Velocity);
        var others = new Dictionary<int, RoadUser>();
        foreach (EntityState entity in entities.Where(IsRoadUser).OrderBy(static entity => entity.Handle))
        {
            _others.TryGetValue(entity.Handle, out RoadUser? known);
            others.Add(entity.Handle, Followed(known, new RoadUser(entity, () => idOf(entity)), seconds, entity.Pose, entity.Velocity));
        }

        (_ego, _others) = (present, others);
        Book.CloseAll(EventEnd.Vanished, seconds, open => open.Users.Any(user => !IsThere(user)));
        var reading = new SceneReading(seconds, present, [.. others.Values.OrderBy(static user => user.Entity.Handle)], roads);
        foreach (IEventWatch watch in _watches)
        {
            watch.Observe(reading, Book);
        }

        Book.CloseAll(EventEnd.Over, seconds, open => open.IsOverAt(seconds));
    }

    /// <summary>Forgets all road users: the game cannot be read, or is another one now.</summary>
    /// <param name="seconds">The game's time, seconds.</param>
    public void Lose(double seconds)
    {
        Book.CloseAll(EventEnd.Vanished, seconds);
        _ego = null;
        _others = [];
    }

    /// <summary>Signs and lights stand beside or above the road, with boxes that reach over it; riders belong to what they ride.</summary>
    private static bool IsRoadUser(EntityState entity) =>
        entity.Class is not (ObjectClass.Sign or ObjectClass.TrafficLight or ObjectClass.Rider);

    private static RoadUser Followed(RoadUser? known, RoadUser present, double seconds, Geometry.Pose pose, Geometry.Vector3D velocity)
    {
        if (known is not null && IsSame(known.Entity, present.Entity) && known.Add(seconds, pose, velocity))
        {
            return known;
        }

        present.Add(seconds, pose, velocity);
        return present;
    }

    private static bool IsSame(EntityState a, EntityState b) => a.Handle == b.Handle && a.Model == b.Model && a.Class == b.Class;

    private bool IsThere(RoadUser user) =>
        ReferenceEquals(user, _ego) || (_others.TryGetValue(user.Entity.Handle, out RoadUser? present) && ReferenceEquals(user, present));
}
