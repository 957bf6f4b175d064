using Harvester.Capture.Harvesting;
using Harvester.Capture.Labelling;
using Harvester.Capture.Tests.Doubles;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Imaging.Pictures;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Game;
using Harvester.Simulation.Models;
using Harvester.Simulation.Rendering;
using Harvester.Simulation.Settings;

namespace Harvester.Simulation.Tests.Pairs;

/// <summary>Harvests moments of a simulated game with their further pictures.</summary>
internal sealed class PairHarvest
{
    private const double TicksPerSecond = 60;
    private const int BmpHeader = 54;

    public static ImageSize Size { get; } = new(280, 210);

    public List<FrameLabel> Labels { get; } = [];

    /// <summary>The pictures of each frame by the names of their files without ending; that of the frame is "frame".</summary>
    public List<Dictionary<string, byte[]>> Pictures { get; } = [];

    /// <summary>The true scene at every tick in which pictures were taken.</summary>
    public List<SceneSnapshot> Scenes { get; } = [];

    /// <summary>What the renderer drew at the first of these ticks, with all objects: depths, and the handles of entities.</summary>
    public RenderTarget? Drawn { get; private set; }

    /// <summary>Handles of the entities by their ids in the first frame.</summary>
    public IReadOnlyDictionary<int, int> Handles { get; private set; } = new Dictionary<int, int>();

    public IReadOnlyList<string> Warnings { get; private set; } = [];

    public SimulatedGame Game { get; private init; } = null!;

    /// <summary>Harvests a game from its beginning.</summary>
    public static PairHarvest Of(SimulationOptions simulation, PairOptions pairs, int frames = 1)
    {
        var harvest = new PairHarvest { Game = new SimulatedGame(simulation) };
        SimulatedGame game = harvest.Game;
        using var sink = new MemorySink();
        var options = new HarvestOptions
        {
            Image = Size,
            Format = ImageFormat.Bmp,
            MaxFrames = frames,
            RateHz = 1,
            Pairs = pairs,
            Faces = ModelFaces.Table,
            ProbeLag = false,
            MaxCalibrationErrorPixels = null,
        };
        using HarvestSession session = new(options, game.Ports, sink);
        while (!session.Status.IsOver)
        {
            // What has not changed is still the same list.
            if (
                session.Step().Phase == HarvestPhase.Photographing
                && (harvest.Scenes.Count == 0 || !ReferenceEquals(harvest.Scenes[^1].Entities, game.Shown.Entities))
            )
            {
                harvest.Scenes.Add(game.Shown);
                harvest.Drawn ??= Copy(game.Render(Size));
            }

            game.Tick(1 / TicksPerSecond);
        }

        Assert.Null(session.Fault);
        harvest.Warnings = [.. session.Warnings.Select(warning => warning.Message)];
        foreach (CapturedFrame frame in sink.Frames)
        {
            harvest.Labels.Add(frame.Label);
            if (harvest.Handles.Count == 0)
            {
                harvest.Handles = frame.Scene!.Ids.ToDictionary(pair => pair.Value, pair => pair.Key);
            }

            Assert.Equal(frame.Label.Pairs.Select(pair => pair.File).OfType<string>(), frame.Files.Select(file => file.Path));
            Dictionary<string, byte[]> pictures = frame.Files.ToDictionary(
                file => Path.GetFileNameWithoutExtension(file.Path),
                file => Decoded(Written(file))
            );
            pictures.Add("frame", [.. frame.Picture.Bytes]);
            harvest.Pictures.Add(pictures);
            frame.Dispose();
        }

        return harvest;
    }

    public static PairOptions Options(string weathers, string hours, string without = "") =>
        new()
        {
            Weathers = [.. weathers.Split(',', StringSplitOptions.RemoveEmptyEntries)],
            Hours = [.. hours.Split(',', StringSplitOptions.RemoveEmptyEntries).Select(int.Parse)],
            Without = [.. without.Split(',', StringSplitOptions.RemoveEmptyEntries).Select(text => HiddenChoice.Parse(text)!)],
            TakesAllTicks = true,
        };

    private static byte[] Written(FrameFile file)
    {
        using var stream = new MemoryStream();
        file.Content(stream, new PngEncoder());
        return stream.ToArray();
    }

    private static RenderTarget Copy(RenderTarget target)
    {
        var copy = new RenderTarget(target.Width, target.Height);
        target.Handles.CopyTo(copy.Handles, 0);
        target.Depth.CopyTo(copy.Depth, 0);
        return copy;
    }

    /// <summary>The pixels of a BMP file: rows from the bottom, blue first, each row filled up to four bytes.</summary>
    private static byte[] Decoded(byte[] file)
    {
        int stride = ((Size.Width * 3) + 3) / 4 * 4;
        byte[] pixels = new byte[Size.PixelCount * 3];
        for (int row = 0; row < Size.Height; row++)
        {
            for (int column = 0; column < Size.Width; column++)
            {
                for (int channel = 0; channel < 3; channel++)
                {
                    pixels[(((row * Size.Width) + column) * 3) + channel] = file[
                        BmpHeader + ((Size.Height - 1 - row) * stride) + (column * 3) + 2 - channel
                    ];
                }
            }
        }

        return pixels;
    }
}
