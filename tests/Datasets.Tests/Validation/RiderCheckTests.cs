using Harvester.Datasets.Validation;
using Harvester.TestSupport;

namespace Harvester.Datasets.Tests.Validation;

/// <summary>Riders that cannot be.</summary>
public sealed class RiderCheckTests : IDisposable
{
    private readonly TestSession _session = new();

    public void Dispose() => _session.Dispose();

    [Theory]
    [InlineData("car", "motorcycle", true, null, "vehicle is given, but it is no rider")]
    [InlineData("rider", "car", null, null, "is no motorcycle or bicycle")]
    [InlineData("rider", "bicycle", false, null, "has hasRider false")]
    [InlineData("rider", "bicycle", true, 0, "vehicle is 0")]
    public void Validate_finds_an_impossible_rider(string kind, string vehicle, bool? hasRider, int? id, string message)
    {
        Ride(kind, vehicle, hasRider, id);

        _session.AssertProblem(2, message);
    }

    [Fact]
    public void Rider_of_a_listed_two_wheeler_is_good()
    {
        Ride("rider", "bicycle", true, null);

        Assert.Empty(SessionValidator.Validate(_session.Open()).Problems);
    }

    private void Ride(string kind, string vehicle, bool? hasRider, int? id)
    {
        for (int line = 0; line < _session.Lines.Count; line++)
        {
            _session.Car(line)["class"] = vehicle;
            _session.Pedestrian(line)["class"] = kind;
        }

        _session.Car(1)["hasRider"] = hasRider;
        _session.Pedestrian(1)["vehicle"] = id ?? _session.Car(1)["id"]!.GetValue<int>();
    }
}
