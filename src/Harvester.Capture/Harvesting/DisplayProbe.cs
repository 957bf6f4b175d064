using Harvester.Capture.Faults;
using Harvester.Capture.Ports;
using Harvester.Geometry.Work;
using Harvester.Sessions.Imaging;

namespace Harvester.Capture.Harvesting;

/// <summary>
/// Photographs the frozen game with its display hidden, shown and hidden again, once before the first frame: hiding may have no effect
/// while the game is frozen.
/// </summary>
internal sealed class DisplayProbe(HarvestOptions options, GamePorts game, PixelBufferPool pool)
{
    /// <summary>Ticks beyond the picture lag until the display has changed.</summary>
    internal const int ChangeTicks = 2;

    /// <summary>The finding; null if the game has no display that can be hidden, or it was not checked.</summary>
    public DisplayFinding? Finding { get; private set; }

    /// <summary>The warning if the display stays in the pictures; otherwise null.</summary>
    public CaptureFault? Warning =>
        Finding is { State: DisplayState.Stays }
            ? new CaptureFault(
                FaultCode.DisplayStays,
                "Hiding the game's display changes nothing in pictures of the frozen game, so that radar and HUD may be in them. "
                    + "Switch them off in the game's settings."
            )
            : null;

    /// <summary>Compares the pictures, over several ticks. The game runs again afterwards, with its display hidden.</summary>
    public IEnumerable<WorkStep> Run()
    {
        if (!options.ChecksDisplay || !options.Freeze || game.Hud is not { } hud)
        {
            yield break;
        }

        var pictures = new List<PixelBuffer>();
        game.Pause.Freeze();
        try
        {
            foreach (bool isShown in new[] { false, true, false })
            {
                if (isShown)
                {
                    hud.Show();
                }
                else
                {
                    hud.Hide();
                }

                for (int tick = 0; tick < options.MaxPictureLagTicks + ChangeTicks; tick++)
                {
                    yield return WorkStep.Tick;
                }

                PixelBuffer picture = pool.Rent();
                pictures.Add(picture);
                if (!game.Screen.Grab(picture).IsGood)
                {
                    yield break;
                }
            }

            PictureRegion? region = DisplayPixels.Region(pictures[0], pictures[1], pictures[2]);
            DisplayState state =
                region is not null ? DisplayState.Hidden
                : hud.IsWanted == true ? DisplayState.Stays
                : DisplayState.NotSeen;
            Finding = new DisplayFinding(state, region?.ToString());
        }
        finally
        {
            hud.Hide();
            game.Pause.Unfreeze();
            pictures.ForEach(pool.Return);
        }
    }
}
