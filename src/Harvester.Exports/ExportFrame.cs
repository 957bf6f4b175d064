using Harvester.Datasets.Masks.Pixels;
using Harvester.Geometry;
using Harvester.Geometry.Grids;
using Harvester.Geometry.PixelMaps;
using Harvester.Sessions.Files;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Lidar;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Images;
using Harvester.Sessions.Rigs;
using Harvester.Sessions.Scenes;

namespace Harvester.Exports;

/// <summary>A frame to export.</summary>
public sealed class ExportFrame
{
    private readonly ObjectSelector _selector;
    private InstanceMap? _mask;
    private InstanceMap? _dividedMask;
    private InstanceMap? _classes;
    private IReadOnlyDictionary<int, InstancePixels>? _pixels;
    private IReadOnlyDictionary<int, InstancePixels>? _dividedPixels;
    private FrameSelection? _selection;
    private RecordedScene? _scene;

    /// <param name="session">The session.</param>
    /// <param name="line">The label, and its line.</param>
    /// <param name="selector">Selects objects.</param>
    /// <param name="format">Format of exported images; null for that of the session.</param>
    /// <param name="hasMeasuredPaint">
    /// Whether the session has lanes from measured paint. A frame in which no paint was measured has no lane lines then: boundaries of a
    /// constant width would stand beside measured lines of other frames.
    /// </param>
    internal ExportFrame(SessionReader session, LabelLine line, ObjectSelector selector, ImageFormat? format, bool hasMeasuredPaint)
    {
        Session = session;
        _selector = selector;
        Label =
            hasMeasuredPaint && line.Label is { Lanes: { Markings: null } lanes } label
                ? label with
                {
                    Lanes = lanes with { Boundaries = [] },
                }
                : line.Label!;
        LabelText = line.Text;
        ImageExtension = format?.Extension() ?? Path.GetExtension(Label.Image);
    }

    /// <summary>The session.</summary>
    internal SessionReader Session { get; }

    /// <summary>Number of the frame in the dataset, from 0, counted over all sessions.</summary>
    public required int Index { get; init; }

    /// <summary>
    /// Number of its sequence, from 0: a place of a session, or one view of it if the session was harvested with a rig. The sequences
    /// of a place follow each other in the order of the views.
    /// </summary>
    public required int SequenceIndex { get; init; }

    /// <summary>Number of the frame in its sequence, from 0.</summary>
    public required int FrameInSequence { get; init; }

    /// <summary>Number of the frame in its session, from 0, counted over the frames of the same view.</summary>
    public required int FrameInSession { get; init; }

    /// <summary>Number of its session, from 0, whatever its view.</summary>
    public required int RecordingIndex { get; init; }

    /// <summary>The rig of its session; null for a single camera.</summary>
    public Rig? Rig { get; init; }

    /// <summary>The noise of the session's inertial unit; null for an ideal one, or none.</summary>
    public ImuNoise? ImuNoise { get; init; }

    /// <summary>Whether it is a moment's first view, or the session has no rig.</summary>
    internal bool IsFirstView => Rig is null || Rig.Cameras[0].Name == Label.View;

    /// <summary>Moments of its session per second; 0 if they are not known.</summary>
    public double RateHz { get; init; }

    /// <summary>The split of the frame.</summary>
    public required string Split { get; init; }

    /// <summary>The camera of the sequence's first frame.</summary>
    public required CameraLabel SequenceCamera { get; init; }

    /// <summary>Game time of the sequence's first frame, seconds.</summary>
    public required double SequenceTimeSeconds { get; init; }

    /// <summary>The label, with all objects.</summary>
    public FrameLabel Label { get; }

    /// <summary>The line of labels.jsonl with the label.</summary>
    public string LabelText { get; }

    /// <summary>Name of the frame in the dataset: eight digits.</summary>
    public string Name => FormattableString.Invariant($"{Index:D8}");

    /// <summary>Extension of the exported image: .png, .bmp or .jpg.</summary>
    public string ImageExtension { get; }

    /// <summary>Whether the image is converted to another format.</summary>
    public bool IsImageConverted => ImageExtension != Path.GetExtension(Label.Image);

    /// <summary>Path of the image.</summary>
    public string ImagePath => PathOf(Label.Image);

    /// <summary>Reads the image.</summary>
    /// <exception cref="DatasetFormatException">The image is missing or damaged.</exception>
    public PixelBuffer ReadImage() => ReadImage(Label.Image);

    /// <summary>Reads an image of the session.</summary>
    /// <exception cref="DatasetFormatException">The image is missing or damaged.</exception>
    internal PixelBuffer ReadImage(string name)
    {
        try
        {
            return PictureReader.Read(PathOf(name));
        }
        catch (DatasetFormatException e)
        {
            throw Problem($"the image '{name}' cannot be read: {e.Message}");
        }
    }

    /// <summary>Path of the mask; null without one.</summary>
    public string? MaskPath => Label.Mask is null ? null : PathOf(Label.Mask);

    /// <summary>Path of the depths of all pixels, or of those that rays measured if it has no others; null without a depth map.</summary>
    internal string? DepthPath => Label.Depth is { } depth ? PathOf(depth.Completed ?? depth.Sparse) : null;

    /// <summary>
    /// Reads the depths of all pixels, or those that rays measured if it has no others, 1/256 m; null without a depth map.
    /// </summary>
    /// <exception cref="DatasetFormatException">The map is missing, damaged or of another size than the image.</exception>
    internal InstanceMap? ReadDepth() =>
        Label.Depth is { } depth ? ReadMap(depth.Completed ?? depth.Sparse, "depth map", PngDecoder.ReadInstanceMap) : null;

    /// <summary>Path of the class map; null without one.</summary>
    public string? ClassMapPath => Label.ClassMap is { } map ? PathOf(map.File) : null;

    /// <summary>The instance mask, read on first use; null if the session has none.</summary>
    /// <exception cref="DatasetFormatException">The mask is missing, damaged or of another size than the image.</exception>
    public InstanceMap? Mask => MaskPath is null ? null : _mask ??= ReadMap(Label.Mask!, "mask", PngDecoder.ReadInstanceMap);

    /// <summary>The class map, read on first use; null if the frame has none.</summary>
    /// <exception cref="DatasetFormatException">The map is missing, damaged or of another size than the image.</exception>
    internal InstanceMap? Classes =>
        Label.ClassMap is { } map ? _classes ??= ReadMap(map.File, "class map", PngDecoder.ReadLabelMap) : null;

    /// <summary>The instance mask with separate pixels for faces and heads; null if the session has none.</summary>
    /// <exception cref="DatasetFormatException">As for <see cref="Mask"/>.</exception>
    internal InstanceMap? DividedMask => Mask is { } mask ? _dividedMask ??= PartPixels.Divide(mask, Label) : null;

    /// <summary>The scene, read on first use; null if the session has none.</summary>
    /// <exception cref="DatasetFormatException">The scene is damaged.</exception>
    internal RecordedScene? Scene => _scene ??= ReadScene();

    /// <summary>The objects to export, by ascending id.</summary>
    internal IReadOnlyList<ExportObject> Objects => Selection.Objects;

    /// <summary>The ignore regions.</summary>
    internal IReadOnlyList<ExportRegion> Ignored => Selection.Ignored;

    /// <summary>Size of the image, pixels.</summary>
    internal Box2D Image => new(0, 0, Label.Camera.Width, Label.Camera.Height);

    private FrameSelection Selection => _selection ??= _selector.Of(this);

    /// <summary>Whether a label is a post whose faces or heads are exported instead.</summary>
    internal bool IsPost(ObjectLabel label) => _selector.IsPost(label, this);

    /// <summary>Number of such labels.</summary>
    internal int PostCount => Label.Objects.Count(IsPost);

    /// <summary>
    /// The pixels of an object or part; null if none is visible or the session has no masks. Those of an object include its parts.
    /// </summary>
    /// <exception cref="DatasetFormatException">As for <see cref="Mask"/>.</exception>
    internal InstancePixels? PixelsOf(ObjectLabel label)
    {
        if (Mask is null)
        {
            return null;
        }

        return label.Parent is null
            ? (_pixels ??= InstancePixels.AllOf(Mask)).GetValueOrDefault(label.Id)
            : (_dividedPixels ??= InstancePixels.AllOf(DividedMask!)).GetValueOrDefault(label.Id);
    }

    /// <summary>The flow from the frame before, whose image is there too; null if there is none.</summary>
    internal FlowLabel? Flow => Label.Channels.Get<FlowLabel>() is { } flow && HasFile(ImageBefore(flow)) ? flow : null;

    /// <summary>Path within the session of the image of the frame before, of the same view.</summary>
    internal string ImageBefore(FlowLabel flow) =>
        FormattableString.Invariant($"{FramePaths.In(FramePaths.Frames, Label.View)}/{flow.From:D8}{Path.GetExtension(Label.Image)}");

    /// <summary>Reads the points of a LiDAR.</summary>
    /// <exception cref="DatasetFormatException">The file is missing or damaged.</exception>
    internal LidarPoint[] ReadPoints(SweepLabel sweep) => ReadPoints(sweep.File);

    /// <summary>Whether the session has a file.</summary>
    internal bool HasFile(string name) => File.Exists(PathOf(name));

    /// <summary>Reads the points of a file.</summary>
    /// <exception cref="DatasetFormatException">The file is missing or damaged.</exception>
    internal LidarPoint[] ReadPoints(string file)
    {
        try
        {
            LidarPoint[] points = LidarFile.Read(InputFile.ReadAllBytes(PathOf(file), LidarFile.MaxPoints * LidarFile.BytesPerPoint));
            return Label.Lidar.FirstOrDefault(sweep => sweep.File == file) is { } sweep && sweep.Points != points.Length
                ? throw Problem($"the points '{file}' are {points.Length}, but the label says {sweep.Points}. Run 'harvester validate'.")
                : points;
        }
        catch (Exception e) when (e is FormatException or FileNotFoundException or DirectoryNotFoundException)
        {
            throw Problem($"the points '{file}' cannot be read: {e.Message}");
        }
    }

    /// <summary>An error message that names this frame.</summary>
    public DatasetFormatException Problem(string message) => new($"{Session.Folder}, frame {Label.Frame}: {message}");

    /// <summary>Path of a file of the session.</summary>
    /// <exception cref="DatasetFormatException">The name points outside the session.</exception>
    internal string PathOf(string name) =>
        Session.IsWithin(name) ? Session.PathOf(name) : throw Problem($"'{name}' points outside the session.");

    private RecordedScene? ReadScene()
    {
        string file = FramePaths.Scene(Label.Frame);
        try
        {
            return HasFile(file) ? SceneParser.Read(PathOf(file), Label) : null;
        }
        catch (DatasetFormatException e)
        {
            throw Problem($"its scene '{file}' cannot be read: {e.Message}");
        }
    }

    /// <summary>Reads a square map of 8 bits.</summary>
    /// <param name="name">Its name.</param>
    /// <param name="kind">What it is, in messages.</param>
    /// <param name="cells">Number of cells along a side.</param>
    /// <exception cref="DatasetFormatException">The map is missing, damaged or of another size.</exception>
    internal InstanceMap ReadCells(string name, string kind, int cells) =>
        ReadMap(name, kind, PngDecoder.ReadLabelMap, (cells, cells), "that of the label");

    /// <summary>Reads a map of voxels, of 8 bits or of 16: square layers, one below the other.</summary>
    /// <param name="name">Its name.</param>
    /// <param name="shape">The size of the box of voxels.</param>
    /// <param name="hasIds">Whether it has the ids of objects, of 16 bits.</param>
    /// <exception cref="DatasetFormatException">The map is missing, damaged or of another size.</exception>
    internal ushort[] ReadVoxels(string name, VoxelShape shape, bool hasIds = false) =>
        ReadMap(
            name,
            "map of voxels",
            hasIds ? PngDecoder.ReadInstanceMap : PngDecoder.ReadLabelMap,
            (shape.Cells, shape.Cells * shape.Layers),
            "that of the label"
        ).Ids;

    private InstanceMap ReadMap(string name, string kind, Func<string, InstanceMap> read) =>
        ReadMap(name, kind, read, (Label.Camera.Width, Label.Camera.Height), "that of the image");

    private InstanceMap ReadMap(string name, string kind, Func<string, InstanceMap> read, (int Width, int Height) size, string owner)
    {
        try
        {
            InstanceMap map = read(PathOf(name));
            return map.Image.Width == size.Width && map.Image.Height == size.Height
                ? map
                : throw new DatasetFormatException($"its size is not {owner}.");
        }
        catch (DatasetFormatException e)
        {
            throw Problem($"the {kind} '{name}' cannot be used: {e.Message}");
        }
    }
}
