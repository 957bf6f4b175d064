using Harvester.Geometry;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Runs.Sheets;

/// <summary>Reads a list of places: CSV with one name,x,y a line. Blank lines and lines that begin with # are ignored.</summary>
public static class PlaceList
{
    /// <summary>A line before the first place may name the columns.</summary>
    private const string Header = "name,x,y";

    private const int MaxLineCharacters = 1 << 12;
    private const int MaxPlaces = 1000;

    /// <summary>The places of a file, in its order.</summary>
    /// <exception cref="DatasetFormatException">A line is not a place, or there are none or too many.</exception>
    /// <exception cref="IOException">The file cannot be read.</exception>
    public static List<SheetPlace> Read(string path)
    {
        string file = Path.GetFileName(path);
        var places = new List<SheetPlace>();
        foreach ((string line, int index) in InputFile.ReadLines(path, MaxLineCharacters).Select((line, index) => (line.Trim(), index)))
        {
            if (line.Length == 0 || line.StartsWith('#') || (places.Count == 0 && line == Header))
            {
                continue;
            }

            int comma = line.IndexOf(',', System.StringComparison.Ordinal);
            double[]? at = comma < 0 ? null : NumberText.ReadList(line[(comma + 1)..], 2);
            if (at is null)
            {
                throw new DatasetFormatException($"{file}, line {index + 1}: expected name,x,y, found '{line}'.");
            }

            if (places.Count == MaxPlaces)
            {
                throw new DatasetFormatException($"{file}, line {index + 1}: more than {MaxPlaces} places, the limit.");
            }

            places.Add(new SheetPlace(line[..comma].Trim(), new Vector2D(at[0], at[1])));
        }

        return places.Count > 0 ? places : throw new DatasetFormatException($"{file}: no place in it; expected lines of name,x,y.");
    }
}
