using System.Globalization;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.PixelMaps;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Images;

namespace Harvester.Datasets.Masks;

/// <summary>
/// A folder with instance maps of another tool: 16-bit greyscale PNG files named by frame number, with or without leading zeros.
/// </summary>
internal sealed class ExternalMaps
{
    private readonly string _folder;
    private readonly Dictionary<int, string> _files = [];

    /// <exception cref="DirectoryNotFoundException">There is no such folder.</exception>
    /// <exception cref="DatasetFormatException">Two files have the same frame number.</exception>
    public ExternalMaps(string folder)
    {
        _folder = folder;
        if (!Directory.Exists(folder))
        {
            throw new DirectoryNotFoundException($"Folder not found: '{folder}'.");
        }

        foreach (string file in Directory.EnumerateFiles(folder, "*.png"))
        {
            if (
                int.TryParse(Path.GetFileNameWithoutExtension(file), NumberStyles.None, CultureInfo.InvariantCulture, out int frame)
                && !_files.TryAdd(frame, InnerPath.Of(folder, Path.GetFileName(file)))
            )
            {
                throw new DatasetFormatException($"'{file}' and '{_files[frame]}' are both masks of frame {frame}; remove one.");
            }
        }
    }

    /// <summary>Reads the map of a frame.</summary>
    /// <exception cref="DatasetFormatException">The map is missing, damaged or of another size; the message names the frame or the
    /// file.</exception>
    public InstanceMap Read(int frame, ImageSize size)
    {
        if (!_files.TryGetValue(frame, out string? file))
        {
            throw new DatasetFormatException($"'{_folder}' has no mask for frame {frame}, expected as {frame:D8}.png.");
        }

        try
        {
            InstanceMap map = PngDecoder.ReadInstanceMap(file);
            return map.Image == size
                ? map
                : throw new DatasetFormatException(
                    $"it is {map.Image.Width} x {map.Image.Height}, but the image of frame {frame} is {size.Width} x {size.Height}."
                );
        }
        catch (DatasetFormatException e)
        {
            throw new DatasetFormatException($"'{file}' cannot be used: {e.Message}", e);
        }
    }
}
