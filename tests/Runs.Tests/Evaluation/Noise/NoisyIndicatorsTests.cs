using Harvester.Capture.Ports;
using Harvester.Driving.Controllers;
using Harvester.Geometry.Lanes;
using Harvester.Geometry.Roads;
using Harvester.Runs.Evaluation.Noise;

namespace Harvester.Runs.Tests.Evaluation.Noise;

public sealed class NoisyIndicatorsTests
{
    private const int Frames = 20_000;

    [Fact]
    public void Drive_has_the_mean_errors_of_the_levels_and_no_bias()
    {
        var section = new LaneSection(3, 5.4);
        LaneIndicators truth = IndicatorCalculator.Compute(0.1, 8.1, section, [new VehicleAhead(1, 30)]);
        List<DrivingState> seen = Drive(truth, section);

        // The mean of this many absolute errors has itself a deviation of about half a percent.
        AssertErrors(seen.Select(state => state.TorcsEquivalent.Angle.Value - 0.1), 0.03);
        AssertErrors(seen.Select(state => state.TorcsEquivalent.ToMarkingML.Value + 2), 0.2);
        AssertErrors(seen.Select(state => state.Indicators.ToMarkingML.Value + 2.7), 0.2 * 1.35);
        AssertErrors(seen.Select(state => state.Indicators.DistMM.Value - 30), 3);
        Assert.All(seen, state => Assert.InRange(state.Indicators.DistLL.Value, 0, 70));
    }

    [Fact]
    public void Drive_leaves_inactive_indicators_as_they_are()
    {
        var section = new LaneSection(1, 4);
        LaneIndicators truth = IndicatorCalculator.Compute(0, 2, section, []);

        Assert.All(
            Drive(truth, section).Take(50),
            state =>
            {
                Assert.Equal(truth.ToMarkingLL, state.Indicators.ToMarkingLL);
                Assert.Equal(truth.DistRR, state.TorcsEquivalent.DistRR);
                Assert.Equal(truth.ToMarkingM, state.TorcsEquivalent.ToMarkingM);
            }
        );
    }

    private static List<DrivingState> Drive(LaneIndicators truth, LaneSection section)
    {
        NotingController controller = new();
        var noisy = new NoisyIndicators(controller, NoiseLevels.Published, 1);
        for (int i = 0; i < Frames; i++)
        {
            noisy.Drive(new DrivingState(truth, TorcsEquivalent.Of(truth, section), true, 10));
        }

        return controller.Seen;
    }

    private static void AssertErrors(IEnumerable<double> errors, double level)
    {
        double[] all = [.. errors];
        Assert.Equal(level, all.Average(Math.Abs), 0.03 * level);
        Assert.Equal(0, all.Average(), 0.04 * level);
    }

    private sealed class NotingController : IController
    {
        public List<DrivingState> Seen { get; } = [];

        public DrivingControls Drive(DrivingState state)
        {
            Seen.Add(state);
            return DrivingControls.Stop;
        }
    }
}
