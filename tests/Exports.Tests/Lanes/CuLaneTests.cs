using System.Globalization;
using Harvester.Geometry;
using Harvester.Geometry.Lanes;
using Harvester.Geometry.PixelMaps;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading.Images;
using Harvester.TestSupport;

namespace Harvester.Exports.Tests.Lanes;

public sealed class CuLaneTests(SimulatedSession simulated) : CheckTests(simulated, "culane")
{
    private const string Lines = "sequence-0000/00000000.lines.txt";
    private const string Truth = "list/train_gt.txt";

    /// <summary>Points have three decimals, and those of the label too.</summary>
    private const double RoundingPixels = 0.002;

    [Fact]
    public void Points_lie_on_the_lines_from_the_bottom_upwards()
    {
        Export();
        FrameLabel[] known = Known();
        Assert.Equal(known.Length, Folder.Lines("out/list/train.txt").Length);
        foreach (FrameLabel label in known)
        {
            string[] lines = Folder.Lines($"out/sequence-0000/{label.Frame:D8}.lines.txt");
            Assert.InRange(lines.Length, 1, 4);
            foreach (string line in lines)
            {
                double[] numbers = [.. line.Split(' ').Select(word => double.Parse(word, CultureInfo.InvariantCulture))];
                for (int i = 0; i < numbers.Length; i += 2)
                {
                    // Pixels have integer centres, so that (0, 0) is half a pixel right of and below the image's corner.
                    var point = new Vector2D(numbers[i] + 0.5, numbers[i + 1] + 0.5);
                    Assert.True(label.Lanes!.Lines.Any(view => LiesOn(view, point)), $"{point} of frame {label.Frame}");
                    Assert.True(i == 0 || numbers[i + 1] < numbers[i - 1]);
                    Assert.Equal(0, numbers[i + 1] % 10);
                }
            }
        }
    }

    [Fact]
    public void Lines_are_the_nearest_two_on_each_side()
    {
        Export();
        foreach ((FrameLabel label, string line) in Known().Zip(Folder.Lines("out/" + Truth)))
        {
            string[] words = line.Split(' ');
            Assert.Equal([$"/sequence-0000/{label.Frame:D8}.png", $"/laneseg_label_w16/sequence-0000/{label.Frame:D8}.png"], words[..2]);
            InstanceMap map = PngDecoder.ReadLabelMap(Folder.PathOf("out" + words[1]));
            for (int place = 1; place <= 4; place++)
            {
                // Another line may cover all of a short one, but nothing has the number of a line that is not there.
                Assert.True(words[1 + place] == "1" || !map.Ids.Contains((ushort)place));
            }

            Assert.Equal(words[2..].Count(flag => flag == "1"), Folder.Lines($"out/sequence-0000/{label.Frame:D8}.lines.txt").Length);
            int[] left = [.. label.Lanes!.Lines.Where(view => view.IsLeftOfCar).Select(view => view.Index).Distinct()];
            Assert.True(words[2 + 1] == "0" || left.Length >= 1);
            Assert.True(words[2] == "0" || left.Length >= 2);
        }
    }

    [Fact]
    public void Maps_show_each_line_sixteen_pixels_wide()
    {
        Export();
        InstanceMap map = PngDecoder.ReadLabelMap(Folder.PathOf("out/laneseg_label_w16/sequence-0000/00000000.png"));
        double[][] lines =
        [
            .. Folder
                .Lines("out/" + Lines)
                .Select(line => line.Split(' ').Select(word => double.Parse(word, CultureInfo.InvariantCulture)).ToArray()),
        ];

        // A pixel at a point of a line is drawn; one farther than 8 from all points and from what joins them, 10 rows apart, is not.
        foreach (double[] line in lines)
        {
            Assert.NotEqual(0, map[Math.Clamp((int)Math.Round(line[0]), 0, 199), (int)line[1]]);
        }

        Assert.All(Enumerable.Range(0, 200), column => Assert.Equal(0, map[column, 0]));
        int row = (int)lines[0][1];
        int[] drawn = [.. Enumerable.Range(0, 200).Where(column => map[column, row] != 0)];
        Assert.All(drawn, column => Assert.Contains(lines, line => DistanceTo(line, column, row) <= 8));
    }

    [Theory]
    [InlineData("^[^ ]+", "x", "a word is not a number.")]
    [InlineData("^[^ ]+ ", "", "it must have pairs of numbers, two or more.")]
    [InlineData("^[^ ]+", "200", "point 1 does not lie in the image of 200 x 150.")]
    [InlineData("^([^ ]+) [^ ]+", "$1 0", "its rows are not whole numbers from the bottom upwards.")]
    public void A_damaged_line_is_found(string pattern, string replacement, string expected) =>
        AssertDamageIsFound(Lines, pattern, replacement, $"{Lines}, line 1: {expected}");

    [Theory]
    [InlineData("^/sequence-0000/00000000", "/sequence-0000/00000099", "its image is not that of list/train.txt.")]
    [InlineData(" [01]$", " 2", "it must have an image, a map and 4 flags, each 0 or 1.")]
    [InlineData("w16/sequence-0000/00000000", "w16/sequence-0000/00000099", "'laneseg_label_w16/sequence-0000/00000099.png' is missing.")]
    public void A_damaged_list_is_found(string pattern, string replacement, string expected) =>
        AssertDamageIsFound(Truth, pattern, replacement, $"{Truth}, line 1: {expected}");

    [Fact]
    public void Lost_points_and_images_are_found()
    {
        Export();
        Delete(Lines);
        Delete("sequence-0000/00000001.png");
        AssertFound($"{Lines}: it is missing, but its image exists.");
        AssertFound("list/train.txt, line 2: '/sequence-0000/00000001.png' is not in the dataset.");
    }

    private FrameLabel[] Known() => [.. Simulated.Open().ReadLabels().Where(label => label.Lanes?.Status == LaneStatus.Known)];

    private static double DistanceTo(double[] line, int column, int row)
    {
        var point = new Vector2D(column, row);
        Vector2D[] points = [.. line.Chunk(2).Select(pair => new Vector2D(pair[0], pair[1]))];
        return Enumerable
            .Range(1, points.Length - 1)
            .Min(i =>
            {
                Vector2D along = points[i] - points[i - 1];
                double share = Math.Clamp((point - points[i - 1]).Dot(along) / along.Dot(along), 0, 1);
                return (points[i - 1] + (along * share) - point).Length;
            });
    }

    private static bool LiesOn(LaneLineView view, Vector2D point) =>
        Enumerable
            .Range(1, view.Points.Count - 1)
            .Any(i =>
            {
                (Vector2D a, Vector2D b) = (view.Points[i - 1].Pixel, view.Points[i].Pixel);
                double share = (point.Y - a.Y) / (b.Y - a.Y);
                return share is >= 0 and <= 1 && Math.Abs(a.X + ((b.X - a.X) * share) - point.X) <= RoundingPixels;
            });
}
