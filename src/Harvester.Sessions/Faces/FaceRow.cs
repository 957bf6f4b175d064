using System.Globalization;
using Harvester.Sessions.Scenes;
using Harvester.Sessions.Text;

namespace Harvester.Sessions.Faces;

/// <summary>One row of a table of faces: the face, or what is wrong with the row.</summary>
internal readonly struct FaceRow
{
    private const int MaxFaceNumber = 99;
    private const char NotUtf8 = '\uFFFD';

    private FaceRow(ModelFace? face, (string Column, string Reason)? problem)
    {
        Face = face;
        Problem = problem;
    }

    public ModelFace? Face { get; }

    public (string Column, string Reason)? Problem { get; }

    public static bool IsHeader(string line) =>
        CsvFields.Split(line) is { } fields
        && fields.Select(field => field.Trim()).SequenceEqual(FaceColumns.Names, StringComparer.OrdinalIgnoreCase);

    public static FaceRow FromCommas(string line)
    {
        List<string>? fields = CsvFields.Split(line);
        if (fields is null)
        {
            return Refused("row", CsvFields.Problem);
        }

        if (fields.Count != FaceColumns.Names.Length)
        {
            return Refused(
                "row",
                FormattableString.Invariant($"{fields.Count} fields instead of {FaceColumns.Names.Length}: {FaceColumns.Header}.")
            );
        }

        return Checked(fields);
    }

    public static FaceRow FromWhitespace(string line, Dictionary<int, int> nextFaces)
    {
        string[] tokens = line.Split([' ', '\t'], StringSplitOptions.RemoveEmptyEntries);
        if (tokens.Length != 8)
        {
            return Refused(
                "row",
                FormattableString.Invariant($"{tokens.Length} fields instead of 8: hash name fulX fulY fulZ blrX blrY blrZ.")
            );
        }

        if (!ModelHash.TryParse(tokens[0], out int hash))
        {
            return Refused("hash", $"'{tokens[0]}' is not a 32-bit number.");
        }

        nextFaces.TryGetValue(hash, out int face);
        FaceRow row = Checked([
            string.Empty,
            tokens[0],
            "sign",
            tokens[1],
            string.Empty,
            face.ToString(CultureInfo.InvariantCulture),
            tokens[2],
            tokens[3],
            tokens[4],
            tokens[5],
            tokens[6],
            tokens[7],
            "-y",
            "estimated",
            "a file of the thesis's form",
        ]);
        nextFaces[hash] = row.Face is null ? face : face + 1;
        return row;
    }

    private static FaceRow Checked(List<string> fields)
    {
        int unreadable = fields.FindIndex(field => field.Trim().Any(letter => letter == NotUtf8 || char.IsControl(letter)));
        if (unreadable >= 0)
        {
            return Refused(FaceColumns.Names[unreadable], "it is not text in UTF-8.");
        }

        string model = fields[0].Trim().ToLowerInvariant();
        if (!TryHash(model, fields[1].Trim(), out int hash, out string hashProblem))
        {
            return Refused("hash", hashProblem);
        }

        if (!TryClass(fields[2].Trim(), out ObjectClass kind))
        {
            return Refused("class", $"'{fields[2]}' is neither sign nor trafficLight.");
        }

        if (!int.TryParse(fields[5], NumberStyles.None, CultureInfo.InvariantCulture, out int face) || face > MaxFaceNumber)
        {
            return Refused("face", $"'{fields[5]}' is not a whole number from 0 to 99.");
        }

        FaceCorners corners = FaceCorners.Parse(fields);
        if (corners.Problem is { } wrong)
        {
            return Refused(wrong.Column, wrong.Reason);
        }

        if (!TryFacing(fields[12].Trim(), out Facing facing))
        {
            return Refused("facing", $"'{fields[12]}' is not one of -y, +y, -x, +x.");
        }

        if (!TryProvenance(fields[13].Trim(), out Provenance provenance))
        {
            return Refused("provenance", $"'{fields[13]}' is not one of measured, derived, estimated.");
        }

        return new FaceRow(
            new ModelFace(
                model,
                hash,
                kind,
                fields[3].Trim(),
                fields[4].Trim(),
                face,
                corners.FrontUpperLeft,
                corners.BackLowerRight,
                facing,
                provenance,
                fields[14].Trim()
            ),
            null
        );
    }

    private static bool TryHash(string model, string text, out int hash, out string problem)
    {
        problem = string.Empty;
        hash = ModelHash.Of(model);
        if (text.Length == 0)
        {
            problem = model.Length == 0 ? "neither a model's name nor its hash is given." : string.Empty;
            return model.Length > 0;
        }

        if (!ModelHash.TryParse(text, out int given))
        {
            problem = $"'{text}' is not a 32-bit number.";
            return false;
        }

        if (model.Length > 0 && given != hash)
        {
            problem = FormattableString.Invariant($"{text} is not the hash of {model}, which is {hash}.");
            return false;
        }

        hash = given;
        return true;
    }

    private static bool TryClass(string text, out ObjectClass kind)
    {
        kind = text.Equals("trafficLight", StringComparison.OrdinalIgnoreCase) ? ObjectClass.TrafficLight : ObjectClass.Sign;
        return kind == ObjectClass.TrafficLight || text.Equals("sign", StringComparison.OrdinalIgnoreCase);
    }

    private static bool TryFacing(string text, out Facing facing)
    {
        facing = text switch
        {
            "+y" => Facing.Front,
            "-x" => Facing.Left,
            "+x" => Facing.Right,
            _ => Facing.Back,
        };
        return facing != Facing.Back || text == "-y";
    }

    private static bool TryProvenance(string text, out Provenance provenance)
    {
        provenance = text switch
        {
            "measured" => Provenance.Measured,
            "derived" => Provenance.Derived,
            _ => Provenance.Estimated,
        };
        return provenance != Provenance.Estimated || text == "estimated";
    }

    private static FaceRow Refused(string column, string reason) => new(null, (column, reason));
}
