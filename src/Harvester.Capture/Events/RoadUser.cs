using Harvester.Geometry;
using Harvester.Sessions.Events;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Events;

/// <summary>A vehicle, person or other object, followed from reading to reading.</summary>
internal sealed class RoadUser
{
    /// <summary>How long readings are kept, seconds.</summary>
    private const double KeptSeconds = 2;

    /// <summary>Times closer than this, seconds, are equal.</summary>
    private const double TimeTolerance = 1e-6;

    private readonly List<UserReading> _readings = [];

    public RoadUser(EntityState entity, Func<int> id)
    {
        Entity = entity;
        IsEgo = false;
        Id = new Lazy<int?>(() => id());
    }

    private RoadUser(EntityState ego)
    {
        Entity = ego;
        IsEgo = true;
        Id = new Lazy<int?>(static () => null);
    }

    /// <summary>Its handle, class, model and size.</summary>
    public EntityState Entity { get; }

    public bool IsEgo { get; }

    /// <summary>Its id in labels, given when it is first asked for; null for the ego.</summary>
    public Lazy<int?> Id { get; }

    public bool IsVehicle => IsEgo || VehicleClasses.AreVehicles(Entity.Class);

    /// <summary>Whether it is a vehicle that drives itself, which a trailer does not.</summary>
    public bool IsDriven => IsVehicle && Entity.Class != ObjectClass.Trailer;

    public bool IsPerson => !IsEgo && VehicleClasses.ArePeople(Entity.Class);

    /// <summary>The readings of the last seconds, the oldest first.</summary>
    public IReadOnlyList<UserReading> Readings => _readings;

    public UserReading Now => _readings[_readings.Count - 1];

    /// <summary>The reading before the present one; null if there is none.</summary>
    public UserReading? Before => _readings.Count > 1 ? _readings[_readings.Count - 2] : null;

    /// <summary>Whether it was there before; one that came into range just now has no motion to judge.</summary>
    public bool IsNew => _readings.Count < 2;

    /// <summary>The ego as a road user.</summary>
    public static RoadUser Ego(EgoState ego) =>
        new(new EntityState(ego.Handle, ObjectClass.Car, ego.Model, ego.Pose, ego.ModelMin, ego.ModelMax, ego.Velocity));

    /// <summary>Adds a reading.</summary>
    /// <returns>False if it was placed elsewhere since the last one; it is then no longer the same road user.</returns>
    public bool Add(double seconds, Pose pose, Vector3D velocity)
    {
        if (_readings.Count > 0)
        {
            UserReading last = Now;
            double speed = Math.Max(last.Velocity.Length, velocity.Length);
            if ((pose.Position - last.Pose.Position).Length > (speed * (seconds - last.Seconds)) + EventRules.JumpMetres)
            {
                return false;
            }
        }

        var box = BodyBox.Of(pose, Entity.ModelMin, Entity.ModelMax);
        _readings.Add(new UserReading(seconds, pose, box, velocity, IsPerson ? 0 : YawRate(seconds, box.Forward)));
        while (_readings[0].Seconds < seconds - KeptSeconds)
        {
            _readings.RemoveAt(0);
        }

        return true;
    }

    /// <summary>
    /// Horizontal speed at a time, m/s, between two readings by their mean weighted by time; null before the oldest reading.
    /// </summary>
    public double? SpeedAt(double seconds)
    {
        for (int i = _readings.Count - 1; i >= 0; i--)
        {
            UserReading reading = _readings[i];
            if (reading.Seconds <= seconds + TimeTolerance)
            {
                UserReading next = _readings[Math.Min(i + 1, _readings.Count - 1)];
                double span = next.Seconds - reading.Seconds;
                double fraction = span > 0 ? Math.Max(0, seconds - reading.Seconds) / span : 0;
                return reading.Speed + (fraction * (next.Speed - reading.Speed));
            }
        }

        return null;
    }

    /// <summary>The road user as it is now, for an event.</summary>
    public EventParticipant Participant() =>
        new(Id.Value, IsEgo ? null : Entity.Class, Entity.Model, Now.Pose, Entity.ModelMin, Entity.ModelMax, Now.Velocity, Now.YawRate);

    private double YawRate(double seconds, Vector2D forward)
    {
        for (int i = _readings.Count - 1; i >= 0; i--)
        {
            UserReading reading = _readings[i];
            double span = seconds - reading.Seconds;
            if (span >= EventRules.YawWindowSeconds - TimeTolerance || (i == 0 && span > 0))
            {
                // The angle from the earlier to the present direction, positive counter-clockwise.
                return Math.Atan2(reading.Box.Forward.Cross(forward), reading.Box.Forward.Dot(forward)) / span;
            }
        }

        return 0;
    }
}
