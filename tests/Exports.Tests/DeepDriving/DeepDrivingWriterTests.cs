using System.Globalization;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading.Images;
using Harvester.TestSupport;

namespace Harvester.Exports.Tests.DeepDriving;

[Collection(SimulatedSession.Collection)]
public sealed class DeepDrivingWriterTests(SimulatedSession simulated) : ExportTests
{
    [Fact]
    public void Images_are_280_by_210_with_thirteen_numbers_each()
    {
        Folder.Export("deepdriving", simulated.Open());
        FrameLabel[] labels = [.. simulated.Open().ReadLabels()];
        Assert.Contains(labels, label => label.Lanes!.Indicators.ToMarkingML.IsValid);
        for (int frame = 0; frame < labels.Length; frame++)
        {
            ImageHeader image = ImageHeader.Read(Folder.PathOf($"out/images/{frame:D8}.png"));
            Assert.Equal((280, 210), (image.Size.Width, image.Size.Height));
            double[] metres = Row($"out/indicators/{frame:D8}.txt");
            double[] normalised = Row($"out/normalised/{frame:D8}.txt");
            Assert.Equal((13, 13), (metres.Length, normalised.Length));

            // The eighth is toMarking_ML; its map to the network's range is 0.16 d + 0.98 of the TORCS value.
            const double rounding = 1e-6;
            Assert.Equal(labels[frame].Lanes!.Indicators.ToMarkingML.Value, metres[7], rounding);
            Assert.Equal((0.16 * labels[frame].Lanes!.TorcsEquivalent.ToMarkingML.Value) + 0.98, normalised[7], rounding);
            Assert.Equal(Math.Clamp((labels[frame].Lanes!.TorcsEquivalent.Angle.Value / 1.1) + 0.5, 0, 1), normalised[0], rounding);
        }
    }

    [Fact]
    public void Table_has_the_same_numbers()
    {
        Folder.Export("deepdriving", simulated.Open());

        string[][] rows = [.. Folder.Lines("out/indicators.csv").Select(line => line.Split(','))];
        Assert.Equal(SimulatedSession.Frames + 1, rows.Length);
        Assert.All(rows, row => Assert.Equal(5 + (4 * 13) + 1, row.Length));
        int first = Array.IndexOf(rows[0], "angle");
        for (int frame = 0; frame < SimulatedSession.Frames; frame++)
        {
            Assert.Equal(
                File.ReadAllText(Folder.PathOf($"out/indicators/{frame:D8}.txt")).Trim(),
                string.Join(' ', rows[frame + 1].Skip(first).Take(13))
            );
            Assert.True(File.Exists(Folder.PathOf("out/" + rows[frame + 1][Array.IndexOf(rows[0], "image")])));
        }
    }

    private double[] Row(string name) =>
        [
            .. File.ReadAllText(Folder.PathOf(name))
                .Split([' ', '\n'], StringSplitOptions.RemoveEmptyEntries)
                .Select(word => double.Parse(word, CultureInfo.InvariantCulture)),
        ];
}
