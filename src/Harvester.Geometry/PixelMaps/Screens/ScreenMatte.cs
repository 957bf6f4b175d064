namespace Harvester.Geometry.PixelMaps.Screens;

/// <summary>
/// Where an object is seen before its screen. A pixel is compared with the same pixel of the picture in which the object is hidden: if the
/// screen is seen there, the pixel is the object's unless more than half of it is the screen's. If something else is in front of the
/// screen there, the pixel is the object's only if it changes, and not as in a shadow.
/// </summary>
internal sealed class ScreenMatte
{
    /// <summary>Pixels that differ by less than this, grey levels, are taken to show the same.</summary>
    public const double SameLevels = 14;

    /// <summary>A pixel with at least this share of the screen shows it alone.</summary>
    private const double ScreenShare = 0.85;

    /// <summary>A change of less than this, grey levels, is that of the screen, whose texture may move.</summary>
    private const double ScreenLevels = 24;

    /// <summary>A pixel with a smaller share of the screen is not a mixture.</summary>
    private const double MixedShare = 0.06;

    /// <summary>Contact shadows on the ground leave at least this fraction of the light.</summary>
    private const double DarkestContact = 0.12;

    /// <summary>A shadow leaves no more than this fraction of the light, and changes the colour by no more than this one.</summary>
    private const double NoShadow = 1.02;
    private const double ShadowTint = 0.1;

    /// <summary>From this share of the screen on, a pixel of the picture without the object is the screen's.</summary>
    private const double HalfShare = 0.5;

    private readonly ScreenView _view;
    private readonly double _darkestShadow;

    /// <summary>Works out the pixels of an object.</summary>
    /// <param name="view">The pictures of the object.</param>
    /// <param name="darkestShadow">The fraction of the light that shadows of this frame leave at least.</param>
    public ScreenMatte(ScreenView view, double darkestShadow)
    {
        (_view, _darkestShadow) = (view, darkestShadow);
        State = new MatteState[view.Width * view.Height];
        Shares = new float[State.Length];
        if (ScreenColour.In(view) is { } colour)
        {
            for (int index = 0; index < State.Length; index++)
            {
                if (view.HasShown[index])
                {
                    State[index] = StateOf(index, colour);
                    Shares[index] = (float)colour.ShareOf(view.Shown(index));
                }
            }

            new MatteEdges(this, view, colour).Settle();
            new MatteDoubts(this, view).Settle();
        }
    }

    public int Left => _view.Left;

    public int Top => _view.Top;

    public int Width => _view.Width;

    public int Height => _view.Height;

    /// <summary>The states of its pixels, row by row.</summary>
    public MatteState[] State { get; }

    /// <summary>The screen's shares of them, if the object were grey.</summary>
    public float[] Shares { get; }

    /// <summary>The state at a place, counted from the upper left corner; outside, nothing is known.</summary>
    public MatteState At(int x, int y) => x < 0 || y < 0 || x >= Width || y >= Height ? MatteState.Unknown : State[(y * Width) + x];

    public bool IsBesideScreen(int x, int y) =>
        At(x - 1, y) == MatteState.Screen
        || At(x + 1, y) == MatteState.Screen
        || At(x, y - 1) == MatteState.Screen
        || At(x, y + 1) == MatteState.Screen;

    /// <summary>Whether a pixel of the image shows the object alone, so that its colour is the object's.</summary>
    public bool IsPure(int column, int row)
    {
        (int x, int y) = (column - Left, row - Top);
        return At(x, y) == MatteState.Object && Shares[(y * Width) + x] < MixedShare && !IsBesideScreen(x, y);
    }

    private MatteState StateOf(int index, ScreenColour screen)
    {
        Vector3D shown = _view.Shown(index);
        if (!_view.HasEmpty[index])
        {
            // Without the picture of the screen alone: what shows neither the screen nor the empty world is the object.
            return screen.ShareOf(shown) > ScreenShare ? MatteState.Screen
                : (shown - _view.None(index)).Length < SameLevels ? MatteState.World
                : MatteState.Object;
        }

        Vector3D empty = _view.Empty(index);

        // How much of the pixel is the screen's where the object is hidden: the rest of the world in front of it has the colour of the
        // picture without objects.
        double share = screen.ShareOf(empty, _view.None(index));
        if (share >= HalfShare)
        {
            return (shown - empty).Length > ScreenLevels && screen.ShareOf(shown) < ScreenShare ? MatteState.Object : MatteState.Screen;
        }

        // The world in front of the screen is unchanged, apart from the screen's share; where it moves, as leaves do, twice its own change
        // is allowed on top.
        if (IsSameWorld(shown, screen.Without(empty, Math.Max(0, share)), share, SameLevels + (2 * UnrestAt(index, screen))))
        {
            return MatteState.World;
        }

        bool isGround = _view.IsGround(index);
        return !IsShadow(shown, empty, isGround ? DarkestContact : _darkestShadow) ? MatteState.Object
            : isGround ? MatteState.World
            : MatteState.Doubt;
    }

    /// <summary>Whether only the screen's share of a pixel has changed, into any colour.</summary>
    private static bool IsSameWorld(Vector3D shown, Vector3D world, double share, double same)
    {
        Vector3D rest = shown - world;

        // In the screen's share any colour from 0 to 255 may have come, so each channel of the rest lies between 0 and 255·share.
        double most = (255 * share) + same;
        return share < MixedShare
            ? rest.Length < same
            : Math.Min(rest.X, Math.Min(rest.Y, rest.Z)) > -same && Math.Max(rest.X, Math.Max(rest.Y, rest.Z)) < most;
    }

    /// <summary>By how much more than usual pixels around differ between the pictures that show the rest of the world.</summary>
    private double UnrestAt(int index, ScreenColour screen)
    {
        (int x, int y) = (index % Width, index / Width);
        double most = SameLevels;
        for (int v = Math.Max(0, y - 1); v <= Math.Min(Height - 1, y + 1); v++)
        {
            for (int u = Math.Max(0, x - 1); u <= Math.Min(Width - 1, x + 1); u++)
            {
                int other = (v * Width) + u;
                if (_view.HasEmpty[other] && screen.ShareOf(_view.Empty(other), _view.None(other)) < MixedShare)
                {
                    most = Math.Max(most, (_view.Empty(other) - _view.None(other)).Length);
                }
            }
        }

        return most - SameLevels;
    }

    private static bool IsShadow(Vector3D shaded, Vector3D lit, double darkest)
    {
        // Least squares for shaded = left·lit. A shadow leaves a plausible fraction of the light and hardly changes the colour.
        double squared = lit.Dot(lit);
        double left = shaded.Dot(lit) / Math.Max(1, squared);
        return left > darkest && left < NoShadow && (shaded - (lit * left)).Length < (ShadowTint * Math.Sqrt(squared)) + SameLevels;
    }
}
