using Harvester.Exports;
using Harvester.Exports.Assembly;
using Harvester.Exports.Formats;
using Harvester.Reports.Comparison;
using Harvester.Sessions.Files;
using Harvester.Sessions.Reading.Files;
using Harvester.TestSupport;

namespace Harvester.Reports.Tests.Comparison;

[Collection(SimulatedSession.Collection)]
public sealed class ComparedDatasetTests(SimulatedSession session) : IDisposable
{
    /// <summary>
    /// Few objects decide: the exports move boxes that lean by centimetres and leave out objects without visible pixels, and nuScenes has
    /// no signs and lights and counts hidden objects. A mistake in a frame, an axis or a unit gives tens of metres or 90 degrees.
    /// </summary>
    private const double MetresToKitti = 2;
    private const double DegreesToKitti = 6;
    private const double ClassesToKitti = 0.1;
    private const double MetresToNuScenes = 6;
    private const double DegreesToNuScenes = 15;
    private const double ClassesToNuScenes = 0.15;

    private readonly string _folder = Directory.CreateTempSubdirectory("harvester-test-").FullName;

    public void Dispose() => Directory.Delete(_folder, recursive: true);

    [Theory]
    [InlineData(" ")]
    [InlineData("\t")]
    [InlineData("  \t")]
    public void KITTI_labels_are_read_in_the_terms_of_the_development_kit(string separator)
    {
        // A car 3 m high whose bottom is 1.5 m below the camera, 3 m to the right and 4 m ahead: its centre is 5 m away.
        Write(
            "label_2/000000.txt",
            "Car 0.25 1 1.5 100 50 150 80 3 1.6 4 3 1.5 4 2.1\nDontCare -1 -1 -10 0 0 9 9 -1 -1 -1 -1000 -1000 -1000 -10\n".Replace(
                " ",
                separator,
                StringComparison.Ordinal
            )
        );
        Write("label_2/000001.txt", "");

        DatasetProfile profile = Read(ComparedKitti.Open(_folder));

        Assert.Equal((2, 1, 1), (profile.Frames, profile.Labels, profile.Classes.Of("Car")));
        Assert.Equal((30, 50), (Only(profile, ComparedQuantity.BoxHeight), Only(profile, ComparedQuantity.BoxWidth)));
        Assert.Equal(1500, Only(profile, ComparedQuantity.BoxArea));
        Assert.Equal((5, 0.25), (Only(profile, ComparedQuantity.Distance), Only(profile, ComparedQuantity.Truncation)));
        Assert.Equal(1.5 * 180 / Math.PI, Only(profile, ComparedQuantity.Orientation), 1e-9);
        Assert.Equal(1, profile.Levels.Of("1, partly occluded"));
        Assert.Equal([0.0, 1], profile.Of(ComparedQuantity.ObjectsPerFrame).Points.Select(point => point.Value));
    }

    [Theory]
    [InlineData("Car 0 0 0 1 1 2 2 1 1 1 1 1 1", "line 1: it has 14 columns instead of 15")]
    [InlineData("Car 0 0 0 1 1 2 2 1 1 1 1 1 x 0", "line 1: a column after the type is not a finite number")]
    [InlineData("Car 0 0 0 1 1 1e200 1e200 1 1 1 1 1 1 0", "of a label is 1E+200; 1000000000 is the limit")]
    [InlineData("Car 0 0 0 3 1 2 2 1 1 1 1 1 1 0", "line 1: right or bottom is less than left or top")]
    public void Bad_KITTI_label_is_refused_with_its_line(string text, string message)
    {
        Write("label_2/000000.txt", text);

        DatasetFormatException e = Assert.Throws<DatasetFormatException>(() => Read(ComparedKitti.Open(_folder)));

        Assert.Contains(message, e.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Folder_without_labels_is_refused()
    {
        string kitti = Assert.Throws<DatasetFormatException>(() => ComparedKitti.Open(_folder)).Message;
        string nuScenes = Assert.Throws<DatasetFormatException>(() => ComparedNuScenes.Open(_folder)).Message;

        Assert.Contains("has no label files", kitti, StringComparison.Ordinal);
        Assert.Contains("has no tables", nuScenes, StringComparison.Ordinal);
    }

    [Fact]
    public void Session_and_its_KITTI_export_have_close_distributions()
    {
        Export("kitti");

        var comparison = new DatasetComparison(Read(ComparedSession.InKittiTerms(session.Open())), Read(ComparedKitti.Open(_folder)));

        Assert.Equal(comparison.First.Frames, comparison.Second.Frames);
        Assert.InRange(comparison.WassersteinOf(ComparedQuantity.Distance)!.Value, 0, MetresToKitti);
        Assert.InRange(comparison.WassersteinOf(ComparedQuantity.Orientation)!.Value, 0, DegreesToKitti);
        Assert.InRange(
            DatasetComparison.Between(comparison.First.Classes, comparison.Second.Classes)!.Value.TotalVariation,
            0,
            ClassesToKitti
        );
        Assert.Equal(comparison.First.Frames, ImageBrightness.Of(Kept(ComparedKitti.Open(_folder)).Images).Count());
    }

    [Fact]
    public void Session_and_its_nuScenes_export_have_close_distributions()
    {
        Export("nuscenes");

        var comparison = new DatasetComparison(Read(ComparedSession.InNuScenesTerms(session.Open())), Read(ComparedNuScenes.Open(_folder)));

        Assert.InRange(comparison.Second.Frames, 1, comparison.First.Frames);
        Assert.InRange(comparison.WassersteinOf(ComparedQuantity.Distance)!.Value, 0, MetresToNuScenes);
        Assert.InRange(comparison.WassersteinOf(ComparedQuantity.Orientation)!.Value, 0, DegreesToNuScenes);
        Assert.InRange(
            DatasetComparison.Between(comparison.First.Classes, comparison.Second.Classes)!.Value.TotalVariation,
            0,
            ClassesToNuScenes
        );
    }

    [Theory]
    [InlineData("kitti", "Cyclist")]
    [InlineData("nuscenes", "vehicle.bicycle")]
    public void Bicycle_and_rider_are_compared_as_one(string terms, string kind)
    {
        using var ridden = new TestSession();
        (ridden.Car(0)["class"], ridden.Car(0)["hasRider"]) = ("bicycle", true);
        (ridden.Pedestrian(0)["class"], ridden.Pedestrian(0)["vehicle"]) = ("rider", (int)ridden.Car(0)["id"]!);
        ridden.Lines.RemoveRange(1, 2);
        double[] bicycle = [.. ridden.Car(0)["box2d"]!.AsArray().Select(side => (double)side!)];
        double[] rider = [.. ridden.Pedestrian(0)["box2d"]!.AsArray().Select(side => (double)side!)];

        DatasetProfile profile = Read(
            terms == "kitti" ? ComparedSession.InKittiTerms(ridden.Open()) : ComparedSession.InNuScenesTerms(ridden.Open())
        );

        Assert.Equal((1, 1), (profile.Labels, profile.Classes.Of(kind)));
        Assert.Equal(Math.Max(bicycle[2], rider[2]) - Math.Min(bicycle[0], rider[0]), Only(profile, ComparedQuantity.BoxWidth));
        Assert.Equal(2, Read(ComparedSession.InItsTerms(ridden.Open())).Labels);
    }

    [Fact]
    public void Session_compared_with_itself_has_no_distance()
    {
        DatasetProfile profile = Read(ComparedSession.InItsTerms(session.Open()));

        var comparison = new DatasetComparison(profile, Read(ComparedSession.InItsTerms(session.Open())));

        Assert.All(
            ComparedQuantity.All.Where(quantity => comparison.First.Of(quantity).Count > 0),
            quantity => Assert.Equal((0.0, 0.0), (comparison.WassersteinOf(quantity), comparison.JensenShannonOf(quantity)))
        );
        Assert.Equal((0.0, 0.0), DatasetComparison.Between(comparison.First.Classes, comparison.Second.Classes));
    }

    private static DatasetProfile Read(IComparedDataset dataset) => dataset.Read(_ => { }, CancellationToken.None);

    private static IComparedDataset Kept(IComparedDataset dataset)
    {
        Read(dataset);
        return dataset;
    }

    private static double Only(DatasetProfile profile, ComparedQuantity quantity) => Assert.Single(profile.Of(quantity).Points).Value;

    private void Export(string format)
    {
        var plan = new ExportPlan(DatasetFormats.Find(format)!, [session.Open()], new ExportOptions());
        new DatasetExporter(plan, _folder, Shard.Whole).Run(_ => { });
    }

    private void Write(string name, string text)
    {
        string path = Path.Combine(_folder, name);
        Directory.CreateDirectory(Path.GetDirectoryName(path)!);
        File.WriteAllText(path, text);
    }
}
