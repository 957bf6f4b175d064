using System;
using System.Collections.Generic;
using System.IO;

namespace Harvester.Sessions.Faces;

/// <summary>
/// Reads a table of spaces of interest strictly: a bad row is refused with its line, column and reason, and the others are used.
/// Two forms are understood, line by line: the project's own, comma-separated with a header; and the thesis's, eight fields
/// separated by spaces (hash, name, and the two corners). Empty lines and lines that begin with # are passed over.
/// </summary>
public static class SpaceTableReader
{
    /// <summary>Reads a table to its end.</summary>
    /// <exception cref="IOException">The file cannot be read.</exception>
    public static SpaceTableContent Read(TextReader text)
    {
        if (text is null)
        {
            throw new ArgumentNullException(nameof(text));
        }

        var spaces = new List<SpaceOfInterest>();
        var problems = new List<SpaceTableProblem>();
        var firstLines = new Dictionary<(int Hash, int Face), int>();
        var facesOfThesisRows = new Dictionary<int, int>();
        bool hasHeader = false;
        int number = 0;
        while (text.ReadLine() is { } line)
        {
            number++;
            string trimmed = line.Trim().TrimStart('\uFEFF');
            if (trimmed.Length == 0 || trimmed[0] == '#')
            {
                continue;
            }

            if (SpaceRow.IsHeader(trimmed))
            {
                hasHeader = true;
                continue;
            }

            SpaceRow row = trimmed.IndexOf(',') >= 0 ? SpaceRow.FromCommas(trimmed) : SpaceRow.FromSpaces(trimmed, facesOfThesisRows);
            if (row.Problem is { } problem)
            {
                problems.Add(new SpaceTableProblem(number, problem.Column, problem.Reason));
            }
            else if (row.Space is { } space)
            {
                if (firstLines.TryGetValue((space.Hash, space.Face), out int first))
                {
                    problems.Add(new SpaceTableProblem(number, "face", FormattableString.Invariant($"face {space.Face} of this model stands in line {first} already.")));
                    continue;
                }

                firstLines.Add((space.Hash, space.Face), number);
                spaces.Add(space);
            }
        }

        return new SpaceTableContent(new SpaceTable(spaces), problems) { HasHeader = hasHeader };
    }
}
