using Harvester.Geometry;
using Harvester.Simulation.Crashes;

namespace Harvester.Simulation.Tests.Crashes;

public sealed class ImpactLawTests
{
    /// <summary>Rounding of a few operations on doubles, relative.</summary>
    private const double Rounding = 1e-9;

    [Fact]
    public void Plastic_head_on_impact_of_equals_stops_both()
    {
        PlanarBody west = Body(1500, 4.5, 1.8, new(-2.24, 0), 0, new(15, 0));
        PlanarBody east = Body(1500, 4.5, 1.8, new(2.24, 0), Math.PI, new(-15, 0));
        Collide(west, east, 0, 0.5);
        Assert.Equal(0, west.Velocity.Length, 9);
        Assert.Equal(0, east.Velocity.Length, 9);
        Assert.Equal(0, west.YawRate, 9);
    }

    [Theory]
    [InlineData(0)]
    [InlineData(0.3)]
    [InlineData(1)]
    public void Central_impact_is_that_of_the_textbook(double restitution)
    {
        PlanarBody lorry = Body(12_000, 8, 2.5, new(-3.99, 0), 0, new(20, 0));
        PlanarBody car = Body(1500, 4.5, 1.8, new(2.24, 0), 0, new(5, 0));
        Collide(lorry, car, restitution, 0.5);

        // v1' = v1 - (1 + e) m2 (v1 - v2) / (m1 + m2), v2' likewise.
        Assert.Equal(20 - ((1 + restitution) * 1500 * 15 / 13_500), lorry.Velocity.X, 9);
        Assert.Equal(5 + ((1 + restitution) * 12_000 * 15 / 13_500), car.Velocity.X, 9);
    }

    [Fact]
    public void Smooth_eccentric_impact_is_that_of_the_textbook()
    {
        // The front of one meets the side of the other 1.2 m ahead of its middle.
        PlanarBody hit = Body(1500, 4.5, 1.8, new(0, 0), 0, default);
        PlanarBody hitter = Body(1500, 4.5, 1.8, new(1.2, 3.14), -Math.PI / 2, new(0, -10));
        BodyContact contact = Contact(hit, hitter);
        Collide(hit, hitter, 0.2, 0);

        // J = (1 + e) v / (1 / m1 + 1 / m2 + a1² / I1), where the arm a1 is 1.2 m and that of the hitter 0; ω1 = -a1 J / I1.
        double inertia = 1500 * ((4.5 * 4.5) + (1.8 * 1.8)) / 12;
        double impulse = 1.2 * 10 / ((2.0 / 1500) + (1.2 * 1.2 / inertia));
        Assert.Equal(1.2, contact.Point.X, 9);
        Assert.Equal(-impulse / 1500, hit.Velocity.Y, 9);
        Assert.Equal(-1.2 * impulse / inertia, hit.YawRate, 9);
        Assert.Equal(-10 + (impulse / 1500), hitter.Velocity.Y, 9);
    }

    [Fact]
    public void Friction_is_at_most_Coulombs()
    {
        // A car scrapes along another at 20 m/s and presses with 1 m/s only.
        PlanarBody still = Body(1500, 4.5, 1.8, default, 0, default);
        PlanarBody scraping = Body(1500, 4.5, 1.8, new(0, 1.79), 0, new(20, -1));
        Vector2D impulse = Collide(still, scraping, 0.1, 0.5);
        Assert.Equal(0.5, -impulse.X / impulse.Y, 9);
    }

    [Fact]
    public void Random_impacts_keep_momentum_and_never_create_energy()
    {
        Random random = new(20_260);
        int impacts = 0;
        for (int i = 0; i < 50_000; i++)
        {
            PlanarBody first = RandomBody(random);
            PlanarBody second = RandomBody(random);
            if (BodyContact.Between(first, second) is not { } contact)
            {
                continue;
            }

            (Vector2D Linear, double Angular) before = Momentum(first, second);
            double energy = first.KineticEnergy + second.KineticEnergy;
            Vector2D impulse = ImpactLaw.Impulse(first, second, contact, random.NextDouble(), 2 * random.NextDouble());
            first.Push(impulse * -1, contact.Point);
            second.Push(impulse, contact.Point);
            impacts += impulse == default ? 0 : 1;
            (Vector2D Linear, double Angular) after = Momentum(first, second);
            double scale = (first.Mass + second.Mass) * 60;
            Assert.True((after.Linear - before.Linear).Length <= Rounding * scale, $"momentum of impact {i}");
            Assert.True(Math.Abs(after.Angular - before.Angular) <= Rounding * scale * 20, $"angular momentum of impact {i}");
            Assert.True(first.KineticEnergy + second.KineticEnergy <= energy * (1 + Rounding), $"energy of impact {i}");
        }

        Assert.True(impacts > 5000, $"Only {impacts} of these bodies collide.");
    }

    [Fact]
    public void Mirrored_impacts_have_mirrored_results()
    {
        PlanarBody left = Body(1500, 4.5, 1.8, new(-1, 0.2), 0.4, new(10, 3));
        PlanarBody right = Body(2000, 5, 1.9, new(1.8, 1.2), 2.4, new(-7, -2));
        PlanarBody leftMirrored = Body(1500, 4.5, 1.8, new(-1, -0.2), -0.4, new(10, -3));
        PlanarBody rightMirrored = Body(2000, 5, 1.9, new(1.8, -1.2), -2.4, new(-7, 2));
        Collide(left, right, 0.2, 0.5);
        Collide(leftMirrored, rightMirrored, 0.2, 0.5);
        Assert.NotEqual(10, left.Velocity.X);
        Assert.Equal(left.Velocity.X, leftMirrored.Velocity.X, 9);
        Assert.Equal(left.Velocity.Y, -leftMirrored.Velocity.Y, 9);
        Assert.Equal(left.YawRate, -leftMirrored.YawRate, 9);
        Assert.Equal(right.YawRate, -rightMirrored.YawRate, 9);
    }

    [Fact]
    public void Contact_of_aligned_rectangles_is_amid_their_overlap()
    {
        BodyContact contact = Contact(Body(1, 4, 2, default, 0, default), Body(1, 4, 2, new(3.9, 0.5), 0, default));
        Assert.Equal(0.1, contact.Depth, 9);
        Assert.Equal(1, contact.Normal.X, 9);
        Assert.Equal(1.95, contact.Point.X, 9);
        Assert.Equal(0.25, contact.Point.Y, 9);
    }

    [Theory]
    [InlineData(0, 0.3)]
    [InlineData(2, 0.3)]
    [InlineData(5, 0.2)]
    [InlineData(30, 0.1)]
    public void Restitution_falls_with_speed(double speed, double expected) => Assert.Equal(expected, ImpactLaw.RestitutionAt(speed), 9);

    private static BodyContact Contact(PlanarBody first, PlanarBody second)
    {
        BodyContact? contact = BodyContact.Between(first, second);
        Assert.NotNull(contact);
        return contact.Value;
    }

    private static Vector2D Collide(PlanarBody first, PlanarBody second, double restitution, double friction)
    {
        BodyContact contact = Contact(first, second);
        Vector2D impulse = ImpactLaw.Impulse(first, second, contact, restitution, friction);
        first.Push(impulse * -1, contact.Point);
        second.Push(impulse, contact.Point);
        return impulse;
    }

    private static (Vector2D Linear, double Angular) Momentum(PlanarBody first, PlanarBody second) =>
        (
            (first.Velocity * first.Mass) + (second.Velocity * second.Mass),
            (first.Position.Cross(first.Velocity) * first.Mass)
                + (first.YawInertia * first.YawRate)
                + (second.Position.Cross(second.Velocity) * second.Mass)
                + (second.YawInertia * second.YawRate)
        );

    private static PlanarBody RandomBody(Random random)
    {
        double length = 1.5 + (10 * random.NextDouble());
        PlanarBody body = Body(
            90 + (12_000 * random.NextDouble()),
            length,
            0.6 + (2 * random.NextDouble()),
            new(4 * random.NextDouble(), 4 * random.NextDouble()),
            7 * random.NextDouble(),
            new(60 * (random.NextDouble() - 0.5), 60 * (random.NextDouble() - 0.5))
        );
        body.YawRate = 4 * (random.NextDouble() - 0.5);
        return body;
    }

    private static PlanarBody Body(double mass, double length, double width, Vector2D place, double yaw, Vector2D velocity) =>
        new(mass, mass * ((length * length) + (width * width)) / 12, length / 2, width / 2)
        {
            Position = place,
            Yaw = yaw,
            Velocity = velocity,
        };
}
