using Harvester.Geometry.Cameras;
using Harvester.Geometry.Lanes;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Imaging.Pictures;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Text;

namespace Harvester.Exports.Formats.DeepDriving;

/// <summary>
/// Writes the training data of DeepDriving: images of 280 x 210 and the thirteen indicators, as a table and as one text file per frame, in
/// metres and as normalised by the network's loss layer. See docs/exports/deepdriving.md.
/// </summary>
internal sealed class DeepDrivingWriter : IDatasetWriter
{
    private const int Decimals = 6;

    /// <summary>Size of the network's input.</summary>
    public static ImageSize Size { get; } = new(280, 210);

    /// <summary>Columns of the indicators. The table keeps the spelling with an underscore, such as toMarking_LL.</summary>
    public static IReadOnlyList<string> Columns { get; } =
    [
        .. IndicatorTable.All.Select(indicator =>
            indicator.Place.Length == 0 ? indicator.Name : indicator.Name.Insert(indicator.Name.Length - indicator.Place.Length, "_")
        ),
    ];

    /// <summary>The header line of the table, with its line end.</summary>
    public static string Header { get; } =
        string.Join(
            ',',
            [
                "frame",
                "split",
                "image",
                "status",
                "fast",
                .. Columns,
                .. Columns.Select(name => "valid_" + name),
                .. Columns.Select(name => "torcs_" + name),
                .. Columns.Select(name => "normalised_" + name),
                "normalised_fast",
            ]
        ) + "\n";

    private readonly ImageFormat _format;
    private readonly PictureEncoder _encoder;
    private readonly PixelBuffer _small = new(Size);

    public DeepDrivingWriter(ExportOptions options)
    {
        _format = options.ImageFormat ?? ImageFormat.Png;
        _encoder = new PictureEncoder(_format, options.JpegQuality);
    }

    public WrittenObjects Write(ExportFrame frame, FrameOutput output)
    {
        LanesLabel lanes = frame.Label.Lanes!;
        string image = $"images/{frame.Name}{_format.Extension()}";
        output.File(image, stream => _encoder.Write(Scaled(frame), stream));
        double[] metres = IndicatorOrder.Values(lanes.Indicators);
        double[] torcs = IndicatorOrder.Values(lanes.TorcsEquivalent);
        double[] normalised = Normalised(torcs);
        output.Text($"indicators/{frame.Name}.txt", Numbers.Row(Decimals, metres) + "\n");
        output.Text($"normalised/{frame.Name}.txt", Numbers.Row(Decimals, normalised) + "\n");
        output.Part(
            "rows",
            string.Join(
                ',',
                [
                    Numbers.Text(frame.Index),
                    frame.Split,
                    image,
                    JsonName.Of(lanes.Status),
                    Flag(lanes.IsFast),
                    .. metres.Select(Text),
                    .. IndicatorTable.All.Select(indicator => Flag(indicator.Of(lanes.Indicators).IsValid)),
                    .. torcs.Select(Text),
                    .. normalised.Select(Text),
                    Text(DeepDrivingNormalisation.Fast(lanes.IsFast)),
                ]
            )
        );
        return default;
    }

    public IEnumerable<AggregateFile> Aggregates(IReadOnlyDictionary<string, int> parts) =>
        [new("indicators.csv", [AggregateSection.Literal(Header), AggregateSection.Lines("rows")])];

    /// <summary>The normalisation of the loss layer, in the order of the indicators.</summary>
    public static double[] Normalised(double[] torcs) =>
        [.. torcs.Zip(IndicatorTable.All, (value, indicator) => indicator.Normalise(value))];

    private static string Text(double value) => InvariantNumber.Format(value, Decimals);

    private static string Flag(bool value) => value ? "1" : "0";

    private PixelBuffer Scaled(ExportFrame frame)
    {
        PixelBuffer picture = frame.ReadImage();
        new ImageScaler(picture.Size, Size).Scale(picture, _small);
        return _small;
    }
}
