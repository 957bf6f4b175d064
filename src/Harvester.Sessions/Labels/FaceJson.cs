using Harvester.Sessions.Text;

namespace Harvester.Sessions.Labels;

/// <summary>Writes the face of a sign or light.</summary>
internal static class FaceJson
{
    public static void Append(JsonText json, FaceLabel? face)
    {
        if (face is null)
        {
            json.Null();
            return;
        }

        json.BeginObject()
            .Key("face")
            .Integer(face.Number)
            .Key("mutcd")
            .String(face.MutcdCode)
            .Key("facesCamera")
            .Boolean(face.FacesCamera)
            .Key("facingAngleDegrees")
            .Number(face.FacingAngleDegrees, LabelDecimals.Degrees)
            .Key("provenance")
            .String(JsonName.Of(face.Provenance));
        json.Key("light");
        if (face.Light is { } light)
        {
            json.BeginObject()
                .Key("state")
                .String(JsonName.Of(light.State))
                .Key("method")
                .String(JsonName.Of(light.Method))
                .Key("litFraction")
                .Number(light.LitFraction, LabelDecimals.Fraction)
                .EndObject();
        }
        else
        {
            json.Null();
        }

        json.EndObject();
    }
}
