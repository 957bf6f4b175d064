using Harvester.Datasets.Validation;

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
            problem => problem.Line == 1 && problem.Message.Contains("two objects have the id 1", StringComparison.Ordinal));
    }

    [Theory]
    [InlineData(0)]
    [InlineData(-7)]
    public void Validate_finds_frame_numbers_that_do_not_rise(int frame)
    {
        _session.Lines[1]["frame"] = frame;

        _session.AssertProblem(2, $"frame is {frame}, but the numbers must rise");
    }
}
