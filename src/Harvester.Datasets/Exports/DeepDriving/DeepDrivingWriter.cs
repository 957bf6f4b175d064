using System.Collections.Generic;
using System.Linq;
using Harvester.Capture.Driving;
using Harvester.Capture.Imaging;
using Harvester.Capture.Labels;
using Harvester.Datasets.Images;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Lanes;

namespace Harvester.Datasets.Exports.DeepDriving;

/// <summary>
/// What DeepDriving trains on: images of 280 x 210 and the thirteen indicators, as a table and as one text file a frame, in metres and as the
/// network's loss has them. See docs/exports/deepdriving.md.
/// </summary>
internal sealed class DeepDrivingWriter : IDatasetWriter
{
    private const int Decimals = 6;

    private static readonly ImageSize Size = new(280, 210);
    private static readonly string Header = string.Join(
        ',',
        [
            "frame", "split", "image", "status", "fast",
            .. IndicatorOrder.Names, .. IndicatorOrder.Names.Select(name => "valid_" + name), .. IndicatorOrder.Names.Select(name => "torcs_" + name),
            .. IndicatorOrder.Names.Select(name => "normalised_" + name), "normalised_fast",
        ]) + "\n";

    private readonly PngEncoder _png = new();
    private readonly PixelBuffer _small = new(Size);

    public void Write(ExportFrame frame, FrameOutput output)
    {
        LanesLabel lanes = frame.Label.Lanes!;
        string image = $"images/{frame.Name}.png";
        output.File(image, stream => _png.Write(Scaled(frame), stream));
        double[] metres = IndicatorOrder.Values(lanes.Indicators);
        double[] torcs = IndicatorOrder.Values(lanes.TorcsEquivalent);
        double[] normalised = Normalised(lanes.TorcsEquivalent);
        output.Text($"indicators/{frame.Name}.txt", Numbers.Row(Decimals, metres) + "\n");
        output.Text($"normalised/{frame.Name}.txt", Numbers.Row(Decimals, normalised) + "\n");
        output.Part("rows", string.Join(
            ',',
            [
                Numbers.Text(frame.Index), frame.Split, image, JsonName.Of(lanes.Status), Flag(lanes.IsFast),
                .. metres.Select(Text), .. NamedIndicators.Of(lanes.Indicators).Select(named => Flag(named.Indicator.IsValid)), .. torcs.Select(Text),
                .. normalised.Select(Text), Text(DeepDrivingNormalisation.Fast(lanes.IsFast)),
            ]));
    }

    public IEnumerable<AggregateFile> Aggregates(IReadOnlyCollection<string> parts) =>
        [new("indicators.csv", [AggregateSection.Literal(Header), AggregateSection.Lines("rows")])];

    private static string Text(double value) => InvariantNumber.Format(value, Decimals);

    private static string Flag(bool value) => value ? "1" : "0";

    /// <summary>The loss layer's maps, in the order of the indicators.</summary>
    private static double[] Normalised(LaneIndicators torcs) =>
    [
        DeepDrivingNormalisation.Angle(torcs.Angle.Value),
        DeepDrivingNormalisation.ToMarkingL(torcs.ToMarkingL.Value),
        DeepDrivingNormalisation.ToMarkingM(torcs.ToMarkingM.Value),
        DeepDrivingNormalisation.ToMarkingR(torcs.ToMarkingR.Value),
        DeepDrivingNormalisation.Dist(torcs.DistL.Value),
        DeepDrivingNormalisation.Dist(torcs.DistR.Value),
        DeepDrivingNormalisation.ToMarkingLL(torcs.ToMarkingLL.Value),
        DeepDrivingNormalisation.ToMarkingML(torcs.ToMarkingML.Value),
        DeepDrivingNormalisation.ToMarkingMR(torcs.ToMarkingMR.Value),
        DeepDrivingNormalisation.ToMarkingRR(torcs.ToMarkingRR.Value),
        DeepDrivingNormalisation.Dist(torcs.DistLL.Value),
        DeepDrivingNormalisation.Dist(torcs.DistMM.Value),
        DeepDrivingNormalisation.Dist(torcs.DistRR.Value),
    ];

    private PixelBuffer Scaled(ExportFrame frame)
    {
        try
        {
            PixelBuffer picture = PngDecoder.ReadRgb(frame.ImagePath);
            new ImageScaler(picture.Size, Size).Scale(picture, _small);
            return _small;
        }
        catch (DatasetFormatException e)
        {
            throw frame.Problem($"the image '{frame.Label.Image}' cannot be scaled: {e.Message}");
        }
    }
}
