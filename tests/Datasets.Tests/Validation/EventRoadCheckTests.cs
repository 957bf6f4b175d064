using Harvester.Datasets.Validation;
using Harvester.Sessions.Reading;

namespace Harvester.Datasets.Tests.Validation;

/// <summary>Events that roads decide: what agrees with the participants passes, and what does not is a problem.</summary>
public class EventRoadCheckTests
{
    /// <summary>One that drives north at 10 m/s.</summary>
    private const string Body =
        "\"model\":\"blista\",\"position\":[0,0,0],\"right\":[1,0,0],\"forward\":[0,1,0],\"up\":[0,0,1],"
        + "\"modelMin\":[-1,-2,0],\"modelMax\":[1,2,1],\"velocity\":[0,10,0],\"yawRate\":0}";

    private const string Ego = "{\"object\":null,\"class\":null," + Body;
    private const string Car = "{\"object\":7,\"class\":\"car\"," + Body;
    private const string Walker = "{\"object\":7,\"class\":\"pedestrian\"," + Body;

    [Theory]
    [InlineData("cutIn", Car + "," + Ego, "\"gap\":5,\"timeGapSeconds\":0.5,\"closingSpeed\":-1")]
    [InlineData("cutIn", Ego + "," + Car, "\"gap\":20,\"timeGapSeconds\":2,\"closingSpeed\":3")]
    [InlineData("redLightRun", Ego, "\"speed\":10,\"redSeconds\":null")]
    [InlineData("redLightRun", Car, "\"speed\":10,\"redSeconds\":2.5")]
    [InlineData("stopSignRun", Car, "\"speed\":10,\"minSpeed\":0.5")]
    [InlineData("offRoad", Ego, "\"speed\":10,\"fromRoad\":2.6")]
    [InlineData("offRoad", Ego, "\"speed\":10,\"fromRoad\":null")]
    [InlineData("wrongWay", Car, "\"speed\":10")]
    public void Event_that_agrees_with_itself_has_no_problem(string kind, string participants, string measures) =>
        Assert.Null(ProblemOf(kind, participants, measures));

    [Theory]
    [InlineData("cutIn", Car + "," + Ego, "\"gap\":5,\"timeGapSeconds\":0.6,\"closingSpeed\":-1", "timeGapSeconds is 0.6 s")]
    [InlineData("cutIn", Car + "," + Ego, "\"gap\":21,\"timeGapSeconds\":2.1,\"closingSpeed\":-1", "timeGapSeconds is 2.1 s")]
    [InlineData("cutIn", Car + "," + Ego, "\"gap\":-1,\"timeGapSeconds\":-0.1,\"closingSpeed\":-1", "timeGapSeconds is -0.1 s")]
    [InlineData("cutIn", Car + "," + Ego, "\"gap\":5,\"timeGapSeconds\":0.5", "a cut-in needs gap")]
    [InlineData("cutIn", Car + "," + "{\"object\":8,\"class\":\"car\"," + Body, "", "the ego is not among")]
    [InlineData("cutIn", Ego, "\"gap\":5,\"timeGapSeconds\":0.5,\"closingSpeed\":-1", "cutIn has 2 participants, not 1.")]
    [InlineData("redLightRun", Walker, "\"speed\":10,\"redSeconds\":1", "pedestrian cannot take part in redLightRun.")]
    [InlineData("redLightRun", Ego, "\"speed\":9,\"redSeconds\":1", "speed is not the participant's horizontal speed.")]
    [InlineData("redLightRun", Ego, "\"redSeconds\":1", "redLightRun needs speed.")]
    [InlineData("redLightRun", Ego, "\"speed\":10,\"redSeconds\":-1", "redSeconds is negative.")]
    [InlineData("stopSignRun", Ego, "\"speed\":10,\"minSpeed\":0.1", "minSpeed must be")]
    [InlineData("stopSignRun", Ego, "\"speed\":10,\"minSpeed\":11", "minSpeed must be")]
    [InlineData("stopSignRun", Ego, "\"speed\":10", "minSpeed must be")]
    [InlineData("offRoad", Ego, "\"speed\":10,\"fromRoad\":2", "fromRoad from 2.5 to 30 m")]
    [InlineData("offRoad", Ego, "\"speed\":10,\"fromRoad\":31", "fromRoad from 2.5 to 30 m")]
    public void Event_that_contradicts_itself_has_a_problem(string kind, string participants, string measures, string expected) =>
        Assert.Contains(expected, ProblemOf(kind, participants, measures), StringComparison.Ordinal);

    private static string? ProblemOf(string kind, string participants, string measures) =>
        EventCheck.FirstProblem(
            EventParser.Parse(
                $"{{\"id\":1,\"kind\":\"{kind}\",\"beginSeconds\":1,\"peakSeconds\":1,\"endSeconds\":2,\"end\":\"over\","
                    + $"\"firstFrame\":null,\"lastFrame\":null,\"participants\":[{participants}],\"measures\":{{{measures}}}}}"
            )
        );
}
