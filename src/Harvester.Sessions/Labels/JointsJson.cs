using Harvester.Sessions.Scenes;
using Harvester.Sessions.Text;

namespace Harvester.Sessions.Labels;

/// <summary>Writes the joints of an object. Fields: docs/dataset-format.md.</summary>
internal static class JointsJson
{
    public static void Append(JsonText json, JointsLabel label)
    {
        json.Key("box2dJoints").Box(label.Box, LabelDecimals.Pixels).Key("joints").BeginArray();
        for (int i = 0; i < label.Joints.Count; i++)
        {
            JointLabel joint = label.Joints[i];
            json.BeginObject()
                .Key("joint")
                .String(JointNames.All[i])
                .Key("position")
                .Vector(joint.Position, LabelDecimals.Metres)
                .Key("pixel");
            if (joint.Pixel is { } pixel)
            {
                json.BeginArray().Number(pixel.X, LabelDecimals.Pixels).Number(pixel.Y, LabelDecimals.Pixels).EndArray();
            }
            else
            {
                json.Null();
            }

            json.Key("visibility").String(JsonName.Of(joint.Visibility)).EndObject();
        }

        json.EndArray();
    }
}
