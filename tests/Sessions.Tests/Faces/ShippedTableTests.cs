using Harvester.Sessions.Faces;
using Harvester.Sessions.Scenes;

namespace Harvester.Sessions.Tests.Faces;

public sealed class ShippedTableTests
{
    private static readonly Lazy<FaceTableContent> Shipped = new(Load);

    [Fact]
    public void Shipped_table_has_no_bad_row() => Assert.Empty(Shipped.Value.Problems);

    [Fact]
    public void Shipped_table_claims_nothing_as_measured() =>
        Assert.All(Shipped.Value.Table.Faces, face => Assert.NotEqual(Provenance.Measured, face.Provenance));

    // The signs of the thesis's Figure 10 for which a model is known; none is known for ONE WAY, R6-1.
    [Theory]
    [InlineData("R1-1")]
    [InlineData("R1-2")]
    [InlineData("R3-4")]
    [InlineData("D13-3")]
    [InlineData("R5-1")]
    [InlineData("R5-1a")]
    public void Shipped_table_has_the_signs_of_figure_10(string code) =>
        Assert.Contains(Shipped.Value.Table.Faces, face => face.MutcdCode == code);

    // The rule of data/README.md: what has a head of red, amber and green is a light, and nothing at a railway crossing has one.
    [Fact]
    public void Shipped_road_signals_are_lights_and_rail_signals_are_signs() =>
        Assert.All(
            Shipped.Value.Table.Faces,
            face =>
            {
                bool isOfRails = face.Model.Contains("rail", StringComparison.Ordinal);
                bool isSignal = !isOfRails && face.Model.StartsWith("prop_traffic_", StringComparison.Ordinal);
                Assert.Equal(isSignal ? ObjectClass.TrafficLight : ObjectClass.Sign, face.Class);
            }
        );

    [Fact]
    public void Shipped_stop_face_begins_at_the_one_published_height() =>
        Assert.Equal(1.9, Assert.Single(Shipped.Value.Table.Of("prop_sign_road_01a")).BackLowerRight.Z);

    private static FaceTableContent Load()
    {
        using StreamReader reader = File.OpenText(Path.Combine(AppContext.BaseDirectory, "spaces_of_interest.csv"));
        return FaceTableReader.Read(reader);
    }
}
