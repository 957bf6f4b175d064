using Harvester.Geometry.Work;
using Harvester.Play.Surveys.Faces;

namespace Harvester.Play.Tests.Surveys.Faces;

public sealed class EdgeSearchTests
{
    private const double Step = 0.05;

    [Fact]
    public void Tip_between_known_points_is_found()
    {
        // The last bisection across and along leaves a sixteenth of the step each.
        const double tolerance = Step / 8;
        const double tip = 0.43;
        var search = new EdgeSearch((across, along) => along <= tip - Math.Abs(across - 0.07), Step, 1);

        WorkRun.Complete(search.Run([(0, 0), (Step, 0), (2 * Step, 0)]));

        Assert.InRange(search.End, tip - tolerance, tip);
    }

    [Fact]
    public void Search_of_an_endless_shape_ends()
    {
        const int steps = 10_000;
        var search = new EdgeSearch(static (_, _) => true, Step, 1);

        Assert.InRange(search.Run([(0, 0), (Step, 0)]).Take(steps).Count(), 1, steps - 1);
    }
}
