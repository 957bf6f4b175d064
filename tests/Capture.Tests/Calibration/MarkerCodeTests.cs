using Harvester.Capture.Calibration;
using Harvester.Geometry;
using Harvester.Geometry.Calibration;
using Harvester.Geometry.Cameras;

namespace Harvester.Capture.Tests.Calibration;

/// <summary>Identifying markers by the pictures that show them.</summary>
public sealed class MarkerCodeTests
{
    private const double Reach = 6;
    private static readonly Pose Pose = new(Vector3D.Zero, Axes.Identity);
    private static readonly MarkerPlan Plan = MarkerPlan.Across(
        new Camera(Pose, new CameraIntrinsics(60, new ImageSize(800, 600), 4.0 / 3, 0.1, Lens.Ideal)),
        7,
        5,
        6,
        [1]
    );

    [Fact]
    public void Each_of_35_markers_has_a_unique_set_of_three_pictures()
    {
        // 7 · 6 · 5 / (3 · 2 · 1) = 35.
        Assert.Equal(35, MarkerCode.Capacity);
        int[][] pictures = [.. Enumerable.Range(0, 35).Select(PicturesOf)];

        Assert.All(pictures, shown => Assert.Equal(3, shown.Length));
        Assert.Equal(35, pictures.Select(shown => string.Join(",", shown)).Distinct().Count());
        Assert.Equal(Enumerable.Range(0, 35), pictures.Select(shown => MarkerCode.MarkerIn(shown)));
        Assert.Equal(-1, MarkerCode.MarkerIn([0, 1]));
        Assert.Equal(-1, MarkerCode.MarkerIn([0, 1, 2, 3]));
    }

    [Theory]
    [InlineData(0, 0)]
    [InlineData(160, 0)]
    [InlineData(-300, 200)]
    public void Markers_are_identified_however_far_they_are_shifted(double shiftX, double shiftY)
    {
        var shift = new Vector2D(shiftX, shiftY);

        IReadOnlyList<Sighting> sightings = Identify(shift, []).SightingsOf(Plan, Pose);

        Assert.Equal(35, sightings.Count);
        Assert.All(
            sightings,
            sighting =>
            {
                PlannedMarker marker = Plan.Markers.Single(marker => marker.CentreOfImage(Pose) == sighting.World);
                Assert.Equal(marker.ExpectedPixel.X + shiftX, sighting.Pixel.X, 1e-9);
                Assert.Equal(marker.ExpectedPixel.Y + shiftY, sighting.Pixel.Y, 1e-9);
            }
        );
    }

    [Fact]
    public void Spots_that_are_not_markers_are_omitted_and_counted()
    {
        // One in a single picture, as a drop of rain, and one in all, as a car that has come.
        MarkerIdentification identification = Identify(
            default,
            [(3, new Vector2D(51, 77)), .. Enumerable.Range(0, 7).Select(picture => (picture, new Vector2D(333, 99)))]
        );

        Assert.Equal(35, identification.SightingsOf(Plan, Pose).Count);
        Assert.Equal(2, identification.UnknownCount);
    }

    [Fact]
    public void Ambiguous_marker_is_omitted()
    {
        MarkerIdentification identification = Identify(default, [.. PicturesOf(4).Select(picture => (picture, new Vector2D(51, 77)))]);

        IReadOnlyList<Sighting> sightings = identification.SightingsOf(Plan, Pose);

        Assert.Equal(34, sightings.Count);
        Assert.DoesNotContain(sightings, sighting => sighting.World == Plan.Markers[4].CentreOfImage(Pose));
    }

    private static int[] PicturesOf(int marker) =>
        [.. Enumerable.Range(0, MarkerCode.Pictures).Where(picture => MarkerCode.IsShown(marker, picture))];

    private static MarkerIdentification Identify(Vector2D shift, IReadOnlyList<(int Picture, Vector2D Centre)> others)
    {
        var identification = new MarkerIdentification(Reach);
        for (int picture = 0; picture < MarkerCode.Pictures; picture++)
        {
            identification.Add(
                picture,
                [
                    .. Plan
                        .Markers.Where((_, marker) => MarkerCode.IsShown(marker, picture))
                        .Select(marker => new MarkerSpot(marker.ExpectedPixel + shift, 113)),
                    .. others.Where(other => other.Picture == picture).Select(other => new MarkerSpot(other.Centre, 113)),
                ]
            );
        }

        return identification;
    }
}
