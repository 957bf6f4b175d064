using Harvester.Simulation.Crashes;

namespace Harvester.Simulation.Tests.Crashes;

public sealed class PersonThrowTests
{
    [Theory]
    [InlineData(6, 0.7)]
    [InlineData(10, 0.75)]
    [InlineData(20, 0.75)]
    public void Distance_is_that_of_Searle(double speed, double drop)
    {
        PersonThrow thrown = new(speed, drop);

        // SAE 831622, launched horizontally: s = v² / (2 μ g) + μ h.
        double expected = (speed * speed / (2 * 0.66 * 9.81)) + (0.66 * drop);
        Assert.Equal(expected, thrown.MetresAt(thrown.TotalSeconds), 9);
        Assert.Equal(expected, thrown.MetresAt(1000), 9);
        Assert.Equal(0, thrown.SpeedAt(thrown.TotalSeconds), 9);
        Assert.Equal(drop, thrown.FallenAt(thrown.FlightSeconds), 9);
    }

    [Fact]
    public void Way_is_the_integral_of_the_speed()
    {
        PersonThrow thrown = new(12, 0.75);
        const double step = 1e-4;
        double way = 0;
        for (double time = step / 2; time < thrown.TotalSeconds; time += step)
        {
            way += thrown.SpeedAt(time) * step;
        }

        Assert.Equal(thrown.MetresAt(thrown.TotalSeconds), way, 0.001);
    }

    [Fact]
    public void Slow_person_falls_and_stays()
    {
        PersonThrow thrown = new(1, 0.75);
        Assert.Equal(thrown.FlightSeconds, thrown.TotalSeconds, 9);
        Assert.Equal(thrown.FlightSeconds * 1, thrown.MetresAt(10), 9);
    }
}
