using Harvester.Sessions.Faces;

namespace Harvester.Play.Features;

/// <summary>A name for a sign that is marked by hand.</summary>
/// <param name="Name">What it says; empty if unknown.</param>
/// <param name="MutcdCode">Its code; empty if it has none or it is unknown.</param>
public readonly record struct SignName(string Name, string MutcdCode)
{
    /// <summary>The names of a list, or of a table if the list is empty. The first is that of an unnamed sign.</summary>
    /// <param name="list">Names separated by semicolons, each followed by a bar and its code if it has one: STOP|R1-1; ONE
    /// WAY|R6-1.</param>
    /// <param name="table">The known faces.</param>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    public static IReadOnlyList<SignName> Choices(string list, FaceTable table)
    {
        if (list is null)
        {
            throw new ArgumentNullException(nameof(list));
        }

        if (table is null)
        {
            throw new ArgumentNullException(nameof(table));
        }

        SignName[] listed = [.. list.Split(';').Where(part => part.Trim().Length > 0).Select(Parse)];
        IEnumerable<SignName> known = table
            .Faces.Where(face => face.Name.Length > 0)
            .Select(face => new SignName(face.Name, face.MutcdCode))
            .Distinct()
            .OrderBy(name => name.Name, StringComparer.Ordinal);
        return [new SignName(string.Empty, string.Empty), .. listed.Length > 0 ? listed : known];
    }

    /// <summary>The name for display.</summary>
    public override string ToString() =>
        Name.Length == 0 ? "(unnamed)"
        : MutcdCode.Length == 0 ? Name
        : $"{Name} {MutcdCode}";

    private static SignName Parse(string part)
    {
        string[] halves = part.Split('|');
        return new SignName(halves[0].Trim(), halves.Length > 1 ? halves[1].Trim() : string.Empty);
    }
}
