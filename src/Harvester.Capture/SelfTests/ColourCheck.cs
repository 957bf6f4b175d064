using Harvester.Capture.Harvesting;
using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Geometry.Work;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.SelfTests;

namespace Harvester.Capture.SelfTests;

/// <summary>
/// Draws patches of known colours and grabs them: they show whether the right window is grabbed, the whole of it, and with the right
/// values. A second card has the same places with other colours, so that what follows the card cannot be mistaken for the game.
/// </summary>
internal sealed class ColourCheck(SelfTestContext context) : SelfCheck(context)
{
    private const int Columns = 3;
    private const int Rows = 3;
    private const double HalfWidth = 0.04;
    private const double HalfHeight = 0.05;

    /// <summary>The colours of the patches; the second card shows each four places farther.</summary>
    private static readonly (byte Red, byte Green, byte Blue)[] Colours =
    [
        (16, 16, 16),
        (64, 64, 64),
        (128, 128, 128),
        (192, 192, 192),
        (235, 235, 235),
        (255, 0, 0),
        (0, 255, 0),
        (0, 0, 255),
        (255, 0, 255),
    ];

    private const int SecondCardShift = 4;

    /// <summary>The inner part of a patch that must follow the card, and the one whose colour is measured.</summary>
    private const double FollowingFraction = 0.85;
    private const double MeasuredFraction = 0.5;

    /// <summary>A patch that follows the card differs by more between the two cards, grey levels.</summary>
    private const int FollowingLevels = 30;

    /// <summary>A pixel is part of a card if it is the same in both pictures of the first card, within noise, grey levels.</summary>
    private const int SameLevels = 14;

    /// <summary>The patches of a card cover 14 % of the window; of an enlarged one, at least this fraction of the picture.</summary>
    private const double MinCardFraction = 0.02;

    private const int LightGrey = 3;
    private const int MiddleGrey = 2;

    public override string Title => "colours of the picture";

    public override IReadOnlyList<string> Checks =>
        [SelfTestChecks.Window, SelfTestChecks.Scale, SelfTestChecks.Exposure, SelfTestChecks.Tones];

    public override IEnumerable<WorkStep> Run()
    {
        if (Game.Card is not { } card)
        {
            Context.ArePicturesUsable = true;
            throw new SelfTestException("this game draws no card of colours.");
        }

        var pictures = new PixelBuffer[Columns];
        for (int number = 0; number < pictures.Length; number++)
        {
            card.Show(Card(number == 1 ? SecondCardShift : 0));
            yield return WorkStep.Do(Wait(Context.PictureTicks));

            pictures[number] = Context.Grab();
        }

        card.Clear();
        Context.Keep("colours", pictures[2]);
        Judge(pictures[0], pictures[1], pictures[2]);
    }

    public override void Release() => Game.Card?.Clear();

    private static Box2D Place(int number)
    {
        double x = 0.1 + (0.4 * (number % Columns));
        double y = 0.15 + (0.35 * (number / Columns));
        return new Box2D(x - HalfWidth, y - HalfHeight, x + HalfWidth, y + HalfHeight);
    }

    private static ColourPatch[] Card(int shift) =>
        [
            .. Enumerable
                .Range(0, Columns * Rows)
                .Select(number =>
                {
                    (byte red, byte green, byte blue) = Colours[(number + shift) % Colours.Length];
                    return new ColourPatch(Place(number), red, green, blue);
                }),
        ];

    /// <summary>The inner part of a patch in a picture, pixels.</summary>
    private Box2D Within(int number, double fraction)
    {
        Box2D place = Place(number);
        (int width, int height) = (Context.Options.Image.Width, Context.Options.Image.Height);
        (double x, double y) = (HalfWidth * (1 - fraction), HalfHeight * (1 - fraction));
        return new Box2D((place.XMin + x) * width, (place.YMin + y) * height, (place.XMax - x) * width, (place.YMax - y) * height);
    }

    /// <summary>Whether nearly all pixels of a box change with the card.</summary>
    private static bool Follows(Box2D box, PixelBuffer first, PixelBuffer second)
    {
        const double nearlyAll = 0.97;
        double pixels = Math.Ceiling(box.Width) * Math.Ceiling(box.Height);
        return PicturePixels.ChangedIn(box, first, second, FollowingLevels) >= nearlyAll * pixels;
    }

    private void Judge(PixelBuffer first, PixelBuffer second, PixelBuffer again)
    {
        int card = PicturePixels
            .Changed(first, second, FollowingLevels)
            .Count(pixel => PicturePixels.Difference(first, again, pixel) <= SameLevels);
        if (Enumerable.Range(0, Colours.Length).All(number => Follows(Within(number, FollowingFraction), first, second)))
        {
            Context.ArePicturesUsable = true;
            Context.Add(SelfTestChecks.Window, SelfTestVerdict.Good, $"Pictures show the game's window.");
            Context.Add(SelfTestChecks.Scale, SelfTestVerdict.Good, $"Pictures show the whole window.");
            JudgeColours(again);
        }
        else if (card >= MinCardFraction * first.Size.PixelCount)
        {
            Context.Add(SelfTestChecks.Window, SelfTestVerdict.Good, $"Pictures show the game's window.");
            Context.Add(
                SelfTestChecks.Scale,
                SelfTestVerdict.Problem,
                $"Colours appear in other places than they were drawn in: ",
                "pictures show a part of the window, because Windows scales it."
            );
            Context.AddUntested(Checks, "pictures do not show the whole window.");
        }
        else
        {
            Context.Add(
                SelfTestChecks.Window,
                SelfTestVerdict.Problem,
                $"Colours drawn in the game do not appear in pictures: another window is grabbed, or none."
            );
            Context.AddUntested(Checks, "pictures do not show the game's window.");
        }
    }

    private void JudgeColours(PixelBuffer picture)
    {
        Vector3D[] seen =
        [
            .. Enumerable.Range(0, Colours.Length).Select(number => PicturePixels.MeanOf(picture, Within(number, MeasuredFraction))),
        ];
        double error = seen.Zip(Colours, (mean, sent) => Greatest(mean - new Vector3D(sent.Red, sent.Green, sent.Blue))).Max();
        if (seen[LightGrey].X >= ColourFinding.ClippedLevel)
        {
            Context.Add(
                SelfTestChecks.Exposure,
                SelfTestVerdict.Problem,
                $"Bright colours are clipped: the grey of 192 comes back as {seen[LightGrey].X:0}, as with HDR or Auto HDR."
            );
            Context.AddUntested(Checks, "bright colours are clipped.");
            return;
        }

        Context.Add(SelfTestChecks.Exposure, SelfTestVerdict.Good, $"The grey of 192 comes back as {seen[LightGrey].X:0}.");
        if (error > ColourFinding.ToleranceLevels)
        {
            Context.Add(
                SelfTestChecks.Tones,
                SelfTestVerdict.Problem,
                $"Colours are off by up to {error:0} of 255; the grey of 128 comes back as {seen[MiddleGrey].X:0}. ",
                "A colour profile, a filter or the brightness of the display changes them."
            );
        }
        else
        {
            Context.Add(SelfTestChecks.Tones, SelfTestVerdict.Good, $"Colours are off by at most {error:0.0} of 255.");
        }
    }

    private static double Greatest(Vector3D difference) =>
        Math.Max(Math.Abs(difference.X), Math.Max(Math.Abs(difference.Y), Math.Abs(difference.Z)));
}
