using Harvester.Datasets.Validation;
using Harvester.TestSupport;

namespace Harvester.Datasets.Tests.Validation;

/// <summary>Frames and objects that contradict each other from line to line.</summary>
public sealed class SequenceCheckTests : IDisposable
{
    private readonly TestSession _session = new();

    public void Dispose() => _session.Dispose();

    [Fact]
    public void Validate_finds_an_id_that_changes_its_model()
    {
        _session.Car(2)["model"] = "dilettante";

        _session.AssertProblem(3, "object 1 is car 'dilettante', but was car 'blista' in an earlier frame");
    }

    [Fact]
    public void Validate_finds_an_id_that_changes_its_class()
    {
        _session.Car(2)["class"] = "truck";

        _session.AssertProblem(3, "object 1 is truck 'blista', but was car 'blista'");
    }

    [Fact]
    public void Validate_finds_an_id_twice_in_a_frame()
    {
        _session.Lines[0]["objects"]![1]!["id"] = 1;

        Assert.Contains(
            SessionValidator.Validate(_session.Open()).Problems,
            problem => problem.Line == 1 && problem.Message.Contains("two objects have the id 1", StringComparison.Ordinal)
        );
    }

    [Theory]
    [InlineData(-5, "timeSeconds is -5; it must be 0 or more")]
    [InlineData(0.25, "timeSeconds is 0.25, but was 0.5 in the previous frame")]
    public void Validate_finds_a_decreasing_time(double seconds, string message)
    {
        _session.Lines[1]["timeSeconds"] = seconds;

        _session.AssertProblem(2, message);
    }

    [Fact]
    public void Validate_accepts_a_time_reset_by_a_restarted_game()
    {
        (_session.Lines[2]["timeSeconds"], _session.Lines[2]["gameFrame"]) = (0.25, 3);

        Assert.Empty(SessionValidator.Validate(_session.Open()).Problems);
    }

    [Theory]
    [InlineData(0)]
    [InlineData(-7)]
    public void Validate_finds_frame_numbers_that_do_not_increase(int frame)
    {
        _session.Lines[1]["frame"] = frame;

        _session.AssertProblem(2, $"frame is {frame}, but the previous frame is");
    }
}
