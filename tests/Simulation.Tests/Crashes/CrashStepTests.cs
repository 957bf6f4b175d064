using Harvester.Geometry;
using Harvester.Simulation.Crashes;

namespace Harvester.Simulation.Tests.Crashes;

public sealed class CrashStepTests
{
    private const double Tick = 1.0 / 60;
    private const double Sliding = 0.7 * 9.81;

    [Theory]
    [InlineData(0, 180)]
    [InlineData(0.9, 180)]
    [InlineData(1.7, 180)]
    [InlineData(0, 90)]
    [InlineData(1, 37)]
    public void Nothing_tunnels_at_50_metres_per_second(double sideways, double angleDegrees)
    {
        CrashBody[] bodies = Meeting(50, sideways, angleDegrees, 2.3);
        List<Impact> impacts = RunAll(bodies, 2);
        Assert.NotEmpty(impacts);
        Assert.Equal(0, bodies.Count(body => !body.IsStruck));
    }

    [Fact]
    public void Bicycle_does_not_tunnel_through_a_bicycle()
    {
        CrashBody[] bodies =
        [
            Driven(1, 88, 1.5, 0.6, new(-10, 0), 0, new(50, 0)),
            Driven(2, 88, 1.5, 0.6, new(0, -10), Math.PI / 2, new(0, 50)),
        ];
        Assert.NotEmpty(RunAll(bodies, 1));
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Bodies_hardly_overlap_in_a_pile_up_and_lose_energy()
    {
        // Ten cars drive into a standing one at 30 m/s, 6 m behind each other.
        CrashBody[] bodies =
        [
            .. Enumerable.Range(0, 10).Select(i => Driven(i + 1, 1500, 4.5, 1.8, new(-6 * (i + 1), 0.11 * (i % 3)), 0, new(30, 0))),
            new CrashBody(99, Body(12_000, 8, 2.5, new(4, 0), 0.1, default), 0, Sliding),
        ];
        double energy = bodies.Sum(body => body.Body.KineticEnergy);
        List<Impact> impacts = [];
        for (int tick = 0; tick < 600; tick++)
        {
            impacts.AddRange(Run(bodies, tick));
            double now = bodies.Sum(body => body.Body.KineticEnergy);
            Assert.True(now <= energy * (1 + 1e-12), $"energy in tick {tick}");
            energy = now;
            Assert.True(MostOverlap(bodies) <= CrashStep.OverlapTolerance, $"{MostOverlap(bodies)} m in tick {tick}");
        }

        Assert.Equal(0, energy);
        Assert.True(impacts.Select(impact => (impact.First, impact.Second)).Distinct().Count() >= 10, "They did not pile up.");
    }

    [Fact]
    public void Symmetric_crash_ends_symmetrically()
    {
        CrashBody[] bodies = Meeting(20, 0.8, 180, 2.3);
        RunAll(bodies, 6);
        Assert.True(bodies.All(body => body.Body.IsAtRest));
        Vector2D first = bodies[0].Body.Position;
        Vector2D second = bodies[1].Body.Position;

        // Half a turn about the middle between the two maps one onto the other. Sines of angles that differ by half a turn are not exact
        // opposites, and friction at the moment of rest lets the difference grow.
        const double tolerance = 1e-6;
        Assert.Equal(0, ((first + second) * 0.5).X, tolerance);
        Assert.Equal(0.4, ((first + second) * 0.5).Y, tolerance);
        Assert.Equal(Math.PI, bodies[1].Body.Yaw - bodies[0].Body.Yaw, tolerance);
        Assert.NotEqual(0, bodies[0].Body.Yaw);
    }

    [Theory]
    [InlineData(0)]
    [InlineData(1.2)]
    public void Sliding_car_comes_to_rest_where_the_formula_says(double direction)
    {
        PlanarBody body = Body(1500, 4.5, 1.8, default, 0.5, new(20 * Math.Cos(direction), 20 * Math.Sin(direction)));
        RunAll([new CrashBody(1, body, 0, Sliding)], 5);

        // s = v² / (2 μ g). The last steps, in which friction is limited to what stops a wheel, change the way by millimetres.
        Assert.True(body.IsAtRest);
        Assert.Equal(20 * 20 / (2 * Sliding), body.Position.Length, 0.01);
    }

    [Fact]
    public void Rear_end_crash_keeps_momentum()
    {
        CrashBody behind = Driven(1, 1500, 4.5, 1.8, new(-5, 0.3), 0, new(20, 0));
        CrashBody ahead = Driven(2, 12_000, 8, 2.5, new(3, 0), 0.05, new(4, 0.2));
        Vector2D before = (behind.Body.Velocity * 1500) + (ahead.Body.Velocity * 12_000);
        CrashBody[] bodies = [Frictionless(behind), Frictionless(ahead)];
        List<Impact> impacts = RunAll(bodies, 1);
        Vector2D after = (bodies[0].Body.Velocity * 1500) + (bodies[1].Body.Velocity * 12_000);
        Assert.NotEmpty(impacts);
        Assert.True((after - before).Length <= 1e-9 * before.Length);

        // The impulses are the truth: their sum is the change of the momentum of the body that was hit.
        Vector2D sum = impacts.Aggregate(default(Vector2D), (total, impact) => total + impact.Impulse);
        Vector2D change = (bodies[1].Body.Velocity * 12_000) - (new Vector2D(4, 0.2) * 12_000);
        Assert.True((sum - change).Length <= 1e-9 * sum.Length);
    }

    [Fact]
    public void Bodies_on_different_levels_pass()
    {
        CrashBody[] bodies =
        [
            new CrashBody(1, Body(1500, 4.5, 1.8, new(-10, 0), 0, new(30, 0)), 0, 0),
            new CrashBody(2, Body(1500, 4.5, 1.8, new(0, 0), 0, default), 6, 0),
        ];
        Assert.Empty(RunAll(bodies, 1));
        Assert.Equal(20, bodies[0].Body.Position.X, 6);
    }

    private static CrashBody Frictionless(CrashBody body) => new(body.Handle, body.Body, body.Height, 0);

    /// <summary>Two equal cars that meet after about ten ticks.</summary>
    private static CrashBody[] Meeting(double speed, double sideways, double angleDegrees, double halfLength)
    {
        double away = halfLength + (speed * Tick * 10.3);
        double yaw = Angles.ToRadians(angleDegrees);
        Vector2D along = new(Math.Cos(yaw), Math.Sin(yaw));
        return
        [
            Driven(1, 1500, 2 * halfLength, 1.8, new(-away, 0), 0, new(speed, 0)),
            Driven(2, 1500, 2 * halfLength, 1.8, (along * -away) + new Vector2D(0, sideways), yaw, along * speed),
        ];
    }

    private static CrashBody Driven(int handle, double mass, double length, double width, Vector2D place, double yaw, Vector2D velocity) =>
        new(handle, Body(mass, length, width, place, yaw, velocity), 0, Sliding) { Way = new DrivenWay(place, yaw, place, 0) };

    private static List<Impact> RunAll(CrashBody[] bodies, double seconds)
    {
        List<Impact> impacts = [];
        for (int tick = 0; tick < seconds / Tick; tick++)
        {
            impacts.AddRange(Run(bodies, tick));
        }

        return impacts;
    }

    private static IReadOnlyList<Impact> Run(CrashBody[] bodies, int tick)
    {
        foreach (CrashBody body in bodies.Where(body => body.Way is not null))
        {
            Vector2D from = body.Body.Position;
            body.Way = new DrivenWay(from, body.Body.Yaw, from + (body.Body.Velocity * Tick), 0);
        }

        return new CrashStep(bodies).Run(Tick, tick * Tick);
    }

    private static double MostOverlap(CrashBody[] bodies) =>
        bodies.SelectMany((first, i) => bodies.Skip(i + 1).Select(second => RectangleOverlap.Depth(first.Body, second.Body))).Max();

    private static PlanarBody Body(double mass, double length, double width, Vector2D place, double yaw, Vector2D velocity) =>
        new(mass, mass * ((length * length) + (width * width)) / 12, length / 2, width / 2)
        {
            Position = place,
            Yaw = yaw,
            Velocity = velocity,
        };
}
