namespace Harvester.Geometry.PixelMaps.Screens;

/// <summary>
/// Settles the outline of an object before its screen. A pixel there may be a mixture of both; it is the object's unless more than half of
/// it is the screen's. The object's own colour is that of pixels near by, brighter or darker. A pixel inside the object that shows
/// something of the screen is glass, and the object's.
/// </summary>
internal sealed class MatteEdges(ScreenMatte matte, ScreenView view, ScreenColour screen)
{
    /// <summary>The second round comes to pixels whose neighbours were the object's before the first.</summary>
    private const int Rounds = 2;

    /// <summary>A larger share than this is the screen's pixel; so little more than half that noise does not decide.</summary>
    private const double MaxShare = 0.505;

    /// <summary>The object's colour is looked for over this many rows and columns on each side.</summary>
    private const int Reach = 2;

    /// <summary>A pixel with a larger share of the screen does not tell the object's colour.</summary>
    private const double TellingShare = 0.4;

    /// <summary>
    /// How much worse an explanation, grey levels, is preferred if its colour is not from an edge itself, or nearer by a squared pixel.
    /// </summary>
    private const double EdgePrice = 40;
    private const double DistancePrice = 4;

    public void Settle()
    {
        for (int round = 0; round < Rounds; round++)
        {
            List<int> trimmed = [];
            for (int y = 0; y < matte.Height; y++)
            {
                for (int x = 0; x < matte.Width; x++)
                {
                    if (matte.At(x, y) == MatteState.Object && !IsInside(x, y) && ShareAt(x, y) > MaxShare)
                    {
                        trimmed.Add((y * matte.Width) + x);
                    }
                }
            }

            trimmed.ForEach(index => matte.State[index] = MatteState.Screen);
        }
    }

    private bool IsInside(int x, int y) =>
        matte.At(x - 1, y) == MatteState.Object
        && matte.At(x + 1, y) == MatteState.Object
        && matte.At(x, y - 1) == MatteState.Object
        && matte.At(x, y + 1) == MatteState.Object;

    /// <summary>The screen's share of a pixel, by the neighbour whose colour explains it best.</summary>
    private double ShareAt(int x, int y)
    {
        int index = (y * matte.Width) + x;
        Vector3D colour = view.Shown(index);
        (double share, double least) = (matte.Shares[index], double.PositiveInfinity);
        for (int v = y - Reach; v <= y + Reach; v++)
        {
            for (int u = x - Reach; u <= x + Reach; u++)
            {
                if ((u == x && v == y) || matte.At(u, v) != MatteState.Object)
                {
                    continue;
                }

                int other = (v * matte.Width) + u;
                bool isEdge = matte.IsBesideScreen(u, v);

                // A neighbour that is a mixture itself, or at the edge and more of the screen than this pixel, has not the object's colour.
                if (matte.Shares[other] > TellingShare || (isEdge && matte.Shares[other] > matte.Shares[index]))
                {
                    continue;
                }

                (double part, double left) = screen.Mixture(colour, view.Shown(other));
                int squared = ((u - x) * (u - x)) + ((v - y) * (v - y));

                // The best explanation is near, not at an edge, and leaves little of the pixel's colour.
                double price = left + (isEdge ? EdgePrice : 0) + (DistancePrice * squared);
                if (price < least)
                {
                    (share, least) = (part, price);
                }
            }
        }

        return share;
    }
}
