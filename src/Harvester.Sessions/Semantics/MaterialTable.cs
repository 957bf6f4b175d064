using System.Globalization;
using System.Text;

namespace Harvester.Sessions.Semantics;

/// <summary>Which class the materials that rays report belong to: data/materials.csv, or a table of the user in its form.</summary>
public sealed class MaterialTable
{
    /// <summary>Name of the shipped table.</summary>
    public const string FileName = "materials.csv";

    /// <summary>Vertical part of the normal from which a surface is ground rather than a wall: 45 degrees.</summary>
    private const double MinLevel = 0.7;

    private const string Header = "material,hash,class,upright";
    private const int Columns = 4;

    private static readonly Lazy<MaterialTable> Shipped = new(ReadShipped);

    private readonly Dictionary<uint, (SemanticClass Level, SemanticClass Upright)> _classes = [];

    private MaterialTable() { }

    /// <summary>The table that is shipped, as it was at compile time.</summary>
    public static MaterialTable BuiltIn => Shipped.Value;

    /// <summary>Number of materials.</summary>
    public int Count => _classes.Count;

    /// <summary>Reads a table of materials and their classes.</summary>
    /// <param name="reader">Its text.</param>
    /// <exception cref="FormatException">A row is invalid; the message names line and column.</exception>
    /// <exception cref="IOException">The text cannot be read.</exception>
    public static MaterialTable Read(TextReader reader)
    {
        if (reader is null)
        {
            throw new ArgumentNullException(nameof(reader));
        }

        var table = new MaterialTable();
        int number = 0;
        while (reader.ReadLine() is { } line)
        {
            number++;
            string text = line.Trim();
            if (text.Length > 0 && text[0] != '#' && text != Header)
            {
                table.Add(number, text.Split(','));
            }
        }

        return table;
    }

    /// <summary>The class of a surface.</summary>
    /// <param name="material">Hash of the material; 0 if unknown.</param>
    /// <param name="normalZ">Vertical part of the surface's unit normal; null if unknown, then the surface is taken as level.</param>
    /// <returns>The class; <see cref="SemanticClass.Other"/> for a material without a row.</returns>
    public SemanticClass ClassOf(uint material, double? normalZ) =>
        !_classes.TryGetValue(material, out (SemanticClass Level, SemanticClass Upright) found) ? SemanticClass.Other
        : normalZ < MinLevel ? found.Upright
        : found.Level;

    private void Add(int line, string[] fields)
    {
        if (fields.Length != Columns)
        {
            throw Refused(line, $"it has {fields.Length} columns; a row has {Columns}: {Header}.");
        }

        string hash = fields[1].Trim();
        if (
            !hash.StartsWith("0x", StringComparison.OrdinalIgnoreCase)
            || !uint.TryParse(hash.Substring(2), NumberStyles.AllowHexSpecifier, CultureInfo.InvariantCulture, out uint material)
        )
        {
            throw Refused(line, $"column hash: '{hash}' is no hash; write it as 0x and 8 hexadecimal digits.");
        }

        SemanticClass level = ClassIn(line, "class", fields[2]);
        SemanticClass upright = fields[3].Trim().Length == 0 ? level : ClassIn(line, "upright", fields[3]);
        if (_classes.ContainsKey(material))
        {
            throw Refused(line, $"column hash: {hash} is in the table twice.");
        }

        _classes.Add(material, (level, upright));
    }

    private static SemanticClass ClassIn(int line, string column, string field) =>
        SemanticClasses.Named(field.Trim()) is { } found
            ? found
            : throw Refused(line, $"column {column}: '{field.Trim()}' is no class of class maps.");

    private static FormatException Refused(int line, string why) => new($"line {line.ToString(CultureInfo.InvariantCulture)}: {why}");

    private static MaterialTable ReadShipped()
    {
        using Stream stream =
            typeof(MaterialTable).Assembly.GetManifestResourceStream(FileName)
            ?? throw new InvalidOperationException($"The program was built without {FileName}.");
        using var reader = new StreamReader(stream, Encoding.UTF8);
        return Read(reader);
    }
}
