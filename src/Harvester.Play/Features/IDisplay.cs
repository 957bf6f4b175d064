using Harvester.Geometry;

namespace Harvester.Play.Features;

/// <summary>Draws over the game's picture, for one frame each time. Positions are fractions of the window unless noted otherwise.</summary>
public interface IDisplay
{
    /// <summary>Draws a filled rectangle.</summary>
    void Rectangle(Box2D place, Colour colour);

    /// <summary>Writes a line; what exceeds about 990 bytes is cut off.</summary>
    /// <param name="text">The line.</param>
    /// <param name="left">Left end.</param>
    /// <param name="top">Upper edge.</param>
    void Text(string text, double left, double top);

    /// <summary>Draws a ball in the world.</summary>
    /// <param name="centre">Metres, world.</param>
    /// <param name="radiusMetres">Radius, metres.</param>
    /// <param name="colour">Its colour, unaffected by lights.</param>
    void Ball(Vector3D centre, double radiusMetres, Colour colour);

    /// <summary>Draws a triangle in the world, which is seen from the side from which its corners run counter-clockwise.</summary>
    /// <param name="a">A corner, metres, world.</param>
    /// <param name="b">The next corner.</param>
    /// <param name="c">The last corner.</param>
    /// <param name="colour">Its colour, unaffected by lights.</param>
    void Triangle(Vector3D a, Vector3D b, Vector3D c, Colour colour);

    /// <summary>Hides the game's own head-up display, map and messages.</summary>
    void HideGames();
}
