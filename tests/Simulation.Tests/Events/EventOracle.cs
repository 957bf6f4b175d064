using Harvester.Sessions.Events;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.World;

namespace Harvester.Simulation.Tests.Events;

/// <summary>
/// Finds the events of docs/events.md in a recording of a whole drive, by brute force and with formulas of its own: it computes for every
/// pair and tick whether the condition holds, and joins the ticks afterwards.
/// </summary>
internal sealed class EventOracle
{
    private const int Nobody = -1;
    private const double Contact = 0.02;
    private const double Horizon = 1.5;
    private const double Hold = 1;
    private const double Window = 0.5;
    private const double HardBraking = 0.45 * 9.80665;
    private const double Tolerance = 1e-6;

    private readonly IReadOnlyList<TrueMoment> _moments;
    private readonly Dictionary<(int Handle, int Tick), int> _since = [];
    private readonly List<TrueEvent> _collisions = [];

    public EventOracle(IReadOnlyList<TrueMoment> moments)
    {
        _moments = moments;
        for (int tick = 0; tick < moments.Count; tick++)
        {
            foreach (int handle in moments[tick].Bodies.Keys)
            {
                _since[(handle, tick)] = tick > 0 && IsSameAsBefore(handle, tick) ? _since[(handle, tick - 1)] : tick;
            }
        }
    }

    /// <summary>All events.</summary>
    /// <param name="site">The town.</param>
    /// <param name="seed">Its seed.</param>
    public List<TrueEvent> Find(Site site, int seed)
    {
        var roads = new RoadOracle(site, seed, _moments, (handle, tick) => _since[(handle, tick)]);
        _collisions.AddRange(Joined(EventKind.Collision, Collisions()));
        return
        [
            .. _collisions,
            .. Joined(EventKind.NearMiss, NearMisses()),
            .. Joined(EventKind.HardBraking, Brakings()),
            .. RoadOracle.Kinds.SelectMany(kind => Joined(kind, roads.Ticks(kind))),
        ];
    }

    private bool IsSameAsBefore(int handle, int tick)
    {
        if (!_moments[tick - 1].Bodies.TryGetValue(handle, out TrueBody? before))
        {
            return false;
        }

        TrueBody now = _moments[tick].Bodies[handle];
        double speed = Math.Max(before.Velocity.Length, now.Velocity.Length);
        return (now.Pose.Position - before.Pose.Position).Length <= (speed * (_moments[tick].Seconds - _moments[tick - 1].Seconds)) + 1;
    }

    private static bool IsLevel(TrueBody a, TrueBody b)
    {
        (double aLow, double aHigh) = a.Heights();
        (double bLow, double bHigh) = b.Heights();
        return aLow <= bHigh && bLow <= aHigh;
    }

    private static bool AreNear(TrueBody a, TrueBody b, double more) =>
        (a.Pose.Position - b.Pose.Position).Length <= a.Reach + b.Reach + more;

    private static bool AreInContact(TrueBody a, TrueBody b) =>
        AreNear(a, b, 1) && IsLevel(a, b) && Polygons.Distance(a.Polygon(), b.Polygon()) <= Contact;

    /// <summary>Ticks in contact of pairs that came into contact, not those that were in contact when they were first seen.</summary>
    private IEnumerable<(int First, int Second, int Tick)> Collisions()
    {
        var touching = new HashSet<(int, int)>();
        var collided = new HashSet<(int, int)>();
        for (int tick = 0; tick < _moments.Count; tick++)
        {
            var now = new HashSet<(int, int)>();
            int[] handles = [.. _moments[tick].Bodies.Keys.Order()];
            for (int i = 0; i < handles.Length; i++)
            {
                TrueBody a = _moments[tick].Bodies[handles[i]];
                for (int j = i + 1; j < handles.Length; j++)
                {
                    TrueBody b = _moments[tick].Bodies[handles[j]];
                    bool isPair =
                        handles[i] == 0 || (a.IsVehicle && b.IsVehicle) || (a.IsVehicle && b.IsPerson) || (a.IsPerson && b.IsVehicle);
                    if (!isPair || !AreInContact(a, b))
                    {
                        continue;
                    }

                    (int, int) pair = (handles[i], handles[j]);
                    now.Add(pair);
                    int start = Math.Max(_since[(handles[i], tick)], _since[(handles[j], tick)]);
                    if (start == tick)
                    {
                        collided.Remove(pair);
                    }
                    else if (!touching.Contains(pair))
                    {
                        collided.Add(pair);
                    }

                    if (collided.Contains(pair))
                    {
                        yield return (handles[i], handles[j], tick);
                    }
                }
            }

            touching = now;
        }
    }

    private IEnumerable<(int First, int Second, int Tick)> NearMisses()
    {
        for (int tick = 1; tick < _moments.Count; tick++)
        {
            TrueBody ego = _moments[tick].Bodies[0];
            foreach ((int handle, TrueBody other) in _moments[tick].Bodies)
            {
                if (
                    handle != 0
                    && !IsColliding(0, handle, _moments[tick].Seconds)
                    && (WouldCollide(tick, ego, handle, other) || HasEncroached(tick, 0, handle) || HasEncroached(tick, handle, 0))
                )
                {
                    yield return (0, handle, tick);
                }
            }
        }
    }

    /// <summary>From the first contact until it is known to be over.</summary>
    private bool IsColliding(int first, int second, double seconds) =>
        _collisions.Exists(each =>
            each.First == first
            && (second == Nobody || each.Second == second)
            && seconds >= each.Begin - Tolerance
            && seconds < each.End + Hold - Tolerance
        );

    private bool WouldCollide(int tick, TrueBody ego, int handle, TrueBody other)
    {
        double relative = Math.Sqrt(Math.Pow(ego.Velocity.X - other.Velocity.X, 2) + Math.Pow(ego.Velocity.Y - other.Velocity.Y, 2));
        if (
            relative < 2
            || _since[(0, tick)] == tick
            || _since[(handle, tick)] == tick
            || !AreNear(ego, other, (ego.Speed + other.Speed) * Horizon)
            || !IsLevel(ego, other)
        )
        {
            return false;
        }

        var course = new TrueCourse(ego, Rate(tick, 0));
        return course.Touches(new TrueCourse(other, other.IsPerson ? 0 : Rate(tick, handle)), Horizon);
    }

    /// <summary>Turning rate over the last 0.1 s, or since it was first seen.</summary>
    private double Rate(int tick, int handle)
    {
        int first = _since[(handle, tick)];
        int then = tick - 1;
        while (then > first && _moments[tick].Seconds - _moments[then].Seconds < 0.1 - Tolerance)
        {
            then--;
        }

        double turned = _moments[tick].Bodies[handle].Bearing - _moments[then].Bodies[handle].Bearing;
        return Math.IEEERemainder(turned, 2 * Math.PI) / (_moments[tick].Seconds - _moments[then].Seconds);
    }

    private bool HasEncroached(int tick, int first, int second)
    {
        TrueBody now = _moments[tick].Bodies[second];
        if (now.Speed < 1)
        {
            return false;
        }

        TrueBody firstNow = _moments[tick].Bodies[first];
        if (AreNear(firstNow, now, 0) && IsLevel(firstNow, now) && Polygons.Distance(firstNow.Polygon(), now.Polygon()) == 0)
        {
            return false;
        }

        for (int then = tick - 1; then >= _since[(first, tick)] && _moments[tick].Seconds - _moments[then].Seconds <= Horizon; then--)
        {
            TrueBody left = _moments[then].Bodies[first];
            double angle = Math.Abs(Math.IEEERemainder(left.Bearing - now.Bearing, Math.PI));
            if (
                angle >= Math.PI / 6
                && AreNear(left, now, 0)
                && IsLevel(left, now)
                && Polygons.Distance(left.Polygon(), now.Polygon()) == 0
            )
            {
                return true;
            }
        }

        return false;
    }

    private IEnumerable<(int First, int Second, int Tick)> Brakings()
    {
        int ticks = (int)Math.Round(Window * 60);
        for (int tick = ticks; tick < _moments.Count; tick++)
        {
            foreach ((int handle, TrueBody body) in _moments[tick].Bodies)
            {
                double seconds = _moments[tick].Seconds;
                if (
                    body.IsVehicle
                    && body.Class != ObjectClass.Trailer
                    && _since[(handle, tick)] <= tick - ticks
                    && (_moments[tick - ticks].Bodies[handle].Speed - body.Speed) / Window >= HardBraking
                    && !IsColliding(handle, Nobody, seconds)
                    && !_collisions.Exists(each =>
                        each.Second == handle && seconds >= each.Begin - Tolerance && seconds < each.End + Hold - Tolerance
                    )
                )
                {
                    yield return (handle, Nobody, tick);
                }
            }
        }
    }

    /// <summary>
    /// Joins the ticks of the same participants unless a second passes between them, or one of them was someone else before.
    /// </summary>
    private IEnumerable<TrueEvent> Joined(EventKind kind, IEnumerable<(int First, int Second, int Tick)> found)
    {
        foreach (var pair in found.GroupBy(each => (each.First, each.Second)))
        {
            int? begin = null;
            int last = 0;
            foreach (int tick in pair.Select(each => each.Tick).Append(int.MaxValue))
            {
                if (begin is { } from && (tick == int.MaxValue || IsParted(kind, pair.Key.First, pair.Key.Second, last, tick)))
                {
                    yield return new TrueEvent(kind, pair.Key.First, pair.Key.Second, _moments[from].Seconds, _moments[last].Seconds);
                    begin = null;
                }

                begin ??= tick;
                last = tick;
            }
        }
    }

    private bool IsParted(EventKind kind, int first, int second, int last, int tick) =>
        _moments[tick - 1].Seconds - _moments[last].Seconds >= Hold - Tolerance
        || _since[(first, tick)] > last
        || (second != Nobody && _since[(second, tick)] > last)
        || (
            kind == EventKind.NearMiss
            && _collisions.Exists(each =>
                each.First == first && each.Second == second && each.Begin > _moments[last].Seconds && each.Begin <= _moments[tick].Seconds
            )
        );
}
