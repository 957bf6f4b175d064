using Harvester.Geometry;

namespace Harvester.Simulation.Crashes;

/// <summary>
/// Moves bodies through one step of the world in parts so short that none enters another by more than <see cref="PartMetres"/>, and lets
/// those that touch exchange impulses.
/// </summary>
/// <param name="bodies">The bodies, in an order that does not depend on chance.</param>
internal sealed class CrashStep(IReadOnlyList<CrashBody> bodies)
{
    /// <summary>How far two bodies approach each other at most in a part of the step, metres.</summary>
    public const double PartMetres = 0.02;

    /// <summary>Overlap that may remain after a step, metres: less than a pixel at any distance at which a contact can be judged.</summary>
    public const double OverlapTolerance = 0.002;

    /// <summary>In a heap, impulses pass from body to body in rounds.</summary>
    private const int ImpulseRounds = 16;
    private const int PartingRounds = 200;

    private readonly Dictionary<(int First, int Second), Impact> _impacts = [];
    private readonly List<(int First, int Second)> _order = [];

    /// <summary>Runs the step.</summary>
    /// <param name="seconds">Its length.</param>
    /// <param name="timeSeconds">The world's time at its end.</param>
    /// <returns>The impacts, one for each pair that touched, in the order in which they began.</returns>
    public IReadOnlyList<Impact> Run(double seconds, double timeSeconds)
    {
        // Each of two bodies moves by less than v t; an elastic impact on a light body at most doubles a speed, hence the factor.
        const double factor = 2;
        double fastest = bodies.Max(body => FastestPoint(body.Body));
        int parts = Math.Max(1, (int)Math.Ceiling(2 * factor * fastest * seconds / PartMetres));
        List<(CrashBody First, CrashBody Second)> pairs = Pairs(factor * fastest * seconds);
        for (int part = 0; part < parts; part++)
        {
            foreach (CrashBody body in bodies)
            {
                body.Move((double)part / parts, (part + 1.0) / parts, seconds);
            }

            Collide(pairs, timeSeconds);
            Part(pairs);
        }

        return [.. _order.Select(pair => _impacts[pair])];
    }

    private static double FastestPoint(PlanarBody body) => body.Velocity.Length + (Math.Abs(body.YawRate) * body.Radius);

    /// <summary>The pairs that can touch in the step.</summary>
    private List<(CrashBody First, CrashBody Second)> Pairs(double metres)
    {
        List<(CrashBody First, CrashBody Second)> pairs = [];
        for (int i = 0; i < bodies.Count; i++)
        {
            for (int j = i + 1; j < bodies.Count; j++)
            {
                double reach = bodies[i].Body.Radius + bodies[j].Body.Radius + (2 * metres);
                Vector2D offset = bodies[j].Body.Position - bodies[i].Body.Position;
                if (bodies[i].MayTouch(bodies[j]) && offset.Dot(offset) < reach * reach)
                {
                    pairs.Add((bodies[i], bodies[j]));
                }
            }
        }

        return pairs;
    }

    private void Collide(List<(CrashBody First, CrashBody Second)> pairs, double timeSeconds)
    {
        bool hasHit = true;
        for (int round = 0; round < ImpulseRounds && hasHit; round++)
        {
            hasHit = false;
            foreach ((CrashBody first, CrashBody second) in pairs)
            {
                if (BodyContact.Between(first.Body, second.Body) is { } contact)
                {
                    hasHit |= Collide(first, second, contact, timeSeconds);
                }
            }
        }
    }

    private bool Collide(CrashBody first, CrashBody second, BodyContact contact, double timeSeconds)
    {
        double closing = (first.Body.VelocityAt(contact.Point) - second.Body.VelocityAt(contact.Point)).Dot(contact.Normal);
        Vector2D impulse = ImpactLaw.Impulse(first.Body, second.Body, contact, ImpactLaw.RestitutionAt(closing), ImpactLaw.VehicleFriction);
        if (impulse == default)
        {
            return false;
        }

        first.Strike(impulse * -1, contact.Point);
        second.Strike(impulse, contact.Point);
        (int, int) pair = (first.Handle, second.Handle);
        if (_impacts.TryGetValue(pair, out Impact? before))
        {
            _impacts[pair] = before with { Impulse = before.Impulse + impulse };
        }
        else
        {
            _order.Add(pair);
            _impacts.Add(pair, new Impact(timeSeconds, first.Handle, second.Handle, impulse, contact.Point, contact.Normal, closing));
        }

        return true;
    }

    /// <summary>Moves bodies apart that overlap, each by the share of the other's mass; their motion stays as it is.</summary>
    private static void Part(List<(CrashBody First, CrashBody Second)> pairs)
    {
        const double left = OverlapTolerance / 2;
        bool hasMoved = true;
        for (int round = 0; round < PartingRounds && hasMoved; round++)
        {
            hasMoved = false;
            foreach ((CrashBody first, CrashBody second) in pairs)
            {
                bool isDriven = first.Way is not null || second.Way is not null;
                if (isDriven || BodyContact.Between(first.Body, second.Body) is not { Depth: > left } contact)
                {
                    continue;
                }

                Vector2D way = contact.Normal * (contact.Depth - left);
                double share = second.Body.Mass / (first.Body.Mass + second.Body.Mass);
                first.Body.Position -= way * share;
                second.Body.Position += way * (1 - share);
                hasMoved = true;
            }
        }
    }
}
