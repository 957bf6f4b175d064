namespace Harvester.Sessions.Faces;

/// <summary>
/// Reads a table of faces strictly: an invalid row is rejected with its line, column and reason, and the others are used. Each line has one
/// of two formats: the project's own, comma-separated with a header; or the thesis's, eight fields separated by spaces (hash, name, and the
/// two corners). Empty lines and lines that begin with # are ignored.
/// </summary>
public static class FaceTableReader
{
    /// <summary>Reads a table to its end.</summary>
    /// <exception cref="IOException">The file cannot be read.</exception>
    public static FaceTableContent Read(TextReader text)
    {
        if (text is null)
        {
            throw new ArgumentNullException(nameof(text));
        }

        var faces = new List<ModelFace>();
        var problems = new List<FaceTableProblem>();
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

            if (FaceRow.IsHeader(trimmed))
            {
                hasHeader = true;
                continue;
            }

            FaceRow row = trimmed.IndexOf(',') >= 0 ? FaceRow.FromCommas(trimmed) : FaceRow.FromWhitespace(trimmed, facesOfThesisRows);
            if (row.Problem is { } problem)
            {
                problems.Add(new FaceTableProblem(number, problem.Column, problem.Reason));
            }
            else if (row.Face is { } face)
            {
                if (firstLines.TryGetValue((face.Hash, face.Number), out int first))
                {
                    problems.Add(
                        new FaceTableProblem(
                            number,
                            "face",
                            FormattableString.Invariant($"face {face.Number} of this model is already in line {first}.")
                        )
                    );
                    continue;
                }

                firstLines.Add((face.Hash, face.Number), number);
                faces.Add(face);
            }
        }

        return new FaceTableContent(new FaceTable(faces), problems) { HasHeader = hasHeader };
    }
}
