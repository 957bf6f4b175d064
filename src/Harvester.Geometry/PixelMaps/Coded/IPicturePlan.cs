namespace Harvester.Geometry.PixelMaps.Coded;

/// <summary>What the pictures of a mask show. Picture 0 shows all targets and nothing else that is not there otherwise.</summary>
public interface IPicturePlan
{
    /// <summary>Number of pictures that the plan takes in all.</summary>
    int PictureCount { get; }

    /// <summary>Whether a picture shows a target, if nothing else hides it.</summary>
    /// <param name="picture">Number of the picture, from 0.</param>
    /// <param name="target">Index of the target, from 0.</param>
    bool IsShown(int picture, int target);

    /// <summary>The sheets that a picture shows.</summary>
    /// <param name="picture">Number of the picture, from 0.</param>
    IReadOnlyList<ScreenSheet> Sheets(int picture);

    /// <summary>Prepares to decode the pictures.</summary>
    /// <param name="pictures">The pictures in this order: red, green and blue of each pixel, rows from the top.</param>
    /// <exception cref="System.ArgumentException">The number or size of the pictures does not match.</exception>
    IMaskDecoder Decoder(IReadOnlyList<byte[]> pictures);
}
