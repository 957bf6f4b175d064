using Harvester.Capture.Harvesting;
using Harvester.Capture.Ports;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Scenes;
using Harvester.Sessions.SelfTests;

namespace Harvester.Capture.SelfTests;

/// <summary>What the checks of a self-test share: the game, and what earlier checks have found.</summary>
internal sealed class SelfTestContext(HarvestOptions options, GamePorts game)
{
    private readonly List<SelfTestLine> _lines = [];
    private readonly List<SelfTestPicture> _pictures = [];

    public HarvestOptions Options { get; } = options;

    public GamePorts Game { get; } = game;

    public SceneReader Reader { get; } = new(game.World, options);

    /// <summary>Whether grabbed pictures show the whole window; without that, no check can use them.</summary>
    public bool ArePicturesUsable { get; set; }

    /// <summary>What was found about the freeze methods.</summary>
    public List<FreezeFinding> Freezes { get; } = [];

    /// <summary>The better freeze method; null if none stops the world.</summary>
    public FreezeFinding? BestFreeze => Freezes.Count > 0 && FreezeReport.Of(Freezes).Used is { HoldsWorld: true } best ? best : null;

    /// <summary>Lag of the picture behind the game, ticks; null if it is not known.</summary>
    public int? LagTicks { get; set; }

    /// <summary>Ticks after which a change is in the picture.</summary>
    public int PictureTicks => (LagTicks ?? Options.MaxPictureLagTicks) + 2;

    /// <summary>Radius of markers in the picture, pixels.</summary>
    public double MarkerRadius => Math.Max(1.5, Options.Image.Height / 100.0);

    /// <summary>The camera that the game reports now, with the lens of the options.</summary>
    public Camera Camera
    {
        get
        {
            CameraState state = Game.World.ReadCamera();
            return new Camera(
                state.Pose,
                new CameraIntrinsics(state.VerticalFovDegrees, Options.Image, state.WindowAspect, state.NearClip, Options.Lens)
            );
        }
    }

    /// <summary>The lens that was measured; null if none was.</summary>
    public Lens? MeasuredLens { get; set; }

    public IReadOnlyList<SelfTestLine> Lines => _lines;

    public IReadOnlyList<SelfTestPicture> Pictures => _pictures;

    /// <summary>Adds the result of a check.</summary>
    /// <param name="check">The check.</param>
    /// <param name="verdict">What it found.</param>
    /// <param name="sentence">The finding, or its beginning.</param>
    /// <param name="rest">The rest of the finding.</param>
    public void Add(string check, SelfTestVerdict verdict, FormattableString sentence, string rest = "") =>
        _lines.Add(new SelfTestLine(check, verdict, FormattableString.Invariant(sentence) + rest));

    /// <summary>Adds a line for each of these checks that has none yet.</summary>
    public void AddUntested(IEnumerable<string> checks, string why)
    {
        foreach (string check in checks)
        {
            if (!_lines.Exists(line => line.Check == check))
            {
                Add(check, SelfTestVerdict.Untested, $"This was not tested: {why}");
            }
        }
    }

    /// <summary>Grabs the picture that the game shows now.</summary>
    /// <exception cref="SelfTestException">The picture cannot be used.</exception>
    public PixelBuffer Grab()
    {
        var picture = new PixelBuffer(Options.Image);
        return Game.Screen.Grab(picture) is { Refusal: { } refusal }
            ? throw new SelfTestException($"the picture of the game cannot be grabbed ({refusal}).")
            : picture;
    }

    public void Keep(string name, PixelBuffer picture) => _pictures.Add(new SelfTestPicture(name, picture));
}
